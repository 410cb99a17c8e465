// Stamps in two columns.
#pragma once

#include "recording/import/raw_table.h"

namespace breakaway {

/// Seconds and nanoseconds, by their names or as a message's first two values, become one column.
void joinStamps(RawTable& table);

}  // namespace breakaway
