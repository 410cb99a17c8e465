// Which drives and references are of the motion that is taken.
#pragma once

#include "recording/import/choose_columns.h"

namespace breakaway {

/// Once the motion is chosen (`motion`: its angle, its speed, or both): drives and references that are called by
/// another thing that moves, another joint, or the other side of a gear are set aside; of those that are left, the
/// motion's own go before what nobody tells. Both sides of a gear share the motor's current and voltage, but no torque.
/// What is called by another word, which nothing else moves by, is a guess. Places and forces of what the motor's
/// rotation moves are set aside.
void setOthersDrivesAside(const RawTable& table, const std::vector<size_t>& motion, std::vector<Choice>& choices);

}  // namespace breakaway
