// What a column is by those beside it, whatever its own name says.
#pragma once

#include <string>
#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// The column stays unused, and why.
void setAside(Choice& choice, Message why);

/// Sets aside what others beside it show to be something else: phases, empty columns and texts, a controller's terms,
/// row numbers, places in space, how far something leans, a vehicle's speed. A position beside a force is linear.
void judgeByNeighbours(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
