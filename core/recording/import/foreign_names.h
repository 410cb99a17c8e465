// Names in a language of which too few words are known: what their units alone tell.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Where at least two names are in other letters or words than English and German, takes the only column with a unit of
/// an angle, a current, a voltage, a torque or a temperature for it if no other is, as a guess.
void takeForeignNames(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
