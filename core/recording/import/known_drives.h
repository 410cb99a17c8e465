// Logs of servos and drives by their registers' names: Dynamixel, thrust stands, AKD, CiA 402, ST's motor control,
// LeRobot.
#pragma once

#include <optional>

#include "recording/import/known_tools.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// `countsPerRev`: a map's, 0 where it says none.
std::optional<ToolColumns> recogniseDrive(RawTable& table, double countsPerRev);

}  // namespace breakaway
