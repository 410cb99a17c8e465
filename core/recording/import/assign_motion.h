// Which of several angles, speeds and drives are one motor's: scored together, not column by column.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Of the columns that may be the angle and the speed, one of each or one alone is chosen by what their names say of
/// them (`ranks`, a value per column, the lower the better), by whether the angle changes as the speed says, by whose
/// they are called (a motor's own go before what only leans or heads, both by one name before two), and by whether a
/// torque, a current or a voltage beside them moves them. What stands in the way of the chosen is set aside; where
/// another motion comes close to it, the choice is a guess. Columns that the map or the tool tells are left as they
/// are.
void assignMotion(const RawTable& table, const std::vector<int>& ranks, std::vector<Choice>& choices);

}  // namespace breakaway
