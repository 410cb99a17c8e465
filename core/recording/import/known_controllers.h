// Logs of motor controllers by what their programs call values: VESC, Betaflight, Phoenix 6, moteus, ODrive.
#pragma once

#include <optional>

#include "recording/import/known_tools.h"
#include "recording/import/raw_table.h"

namespace breakaway {

std::optional<ToolColumns> recogniseController(RawTable& table);

}  // namespace breakaway
