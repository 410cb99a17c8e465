// Electrical turns beside the shaft's own.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Of two angles or two speeds in one unit, the one that moves as the other, which is called the shaft's or the
/// encoder's, but a whole number of times as fast, is in electrical turns: it is set aside. An observer's angle has no
/// other sign of it.
void setElectricalAside(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
