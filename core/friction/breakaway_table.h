// All breakaways of a sweep as a table.
#pragma once

#include <string>
#include <vector>

#include "base/axis.h"
#include "friction/measurements.h"

namespace breakaway {

/// CSV text: angle_rad, way, turn, bin, current_A, torque_Nm, outlier; on a linear axis position_m and force_N.
std::string breakawayTable(const std::vector<BreakawayEvent>& events, Axis axis = Axis::rotary);

}  // namespace breakaway
