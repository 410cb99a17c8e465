// Which of several angles and speeds go together, by their values.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Where the angle that would be taken moves otherwise than the speed that would be, and another angle or speed beside
/// them agrees, sets aside what is no motor's: a robot's tilt and its rate beside its wheel's speed. `angle` and
/// `speed` are the columns that would be taken.
void setStrangersAside(const RawTable& table, size_t angle, size_t speed, std::vector<Choice>& choices);

}  // namespace breakaway
