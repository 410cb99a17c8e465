// SimpleFOC's monitor: rows without names, or with its own.
#pragma once

#include <optional>

#include "recording/import/known_tools.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Names the columns of rows without names.
std::optional<ToolColumns> recogniseSimpleFoc(RawTable& table);

}  // namespace breakaway
