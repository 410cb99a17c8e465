// What a simulated board's shaft really does, whatever its encoder says, and a push on it from outside: for studies,
// figures and tests of what stops it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/result.h"
#include "experiment/drive.h"

namespace breakaway {

/// At the beginning of a control tick; m on a linear axis.
struct ShaftMotion {
  double time_s = 0.0, angle_rad = 0.0, velocity_rad_per_s = 0.0;
  bool driven = false;  ///< the windings aren't open
};
using ShaftWatch = std::function<void(const ShaftMotion&)>;

/// As openDrive() of simulated_board.h; `watch` is called in every tick of an advance().
Result<std::unique_ptr<Drive>> openWatched(const std::string& uri, unsigned seed, ShaftWatch watch);

/// A torque on the shaft from outside, towards growing angle; times from power-up.
struct ShaftPush {
  double torque_Nm = 0.0, start_s = 0.0, duration_s = 0.0;
};

/// As openDrive() of simulated_board.h, of a rig whose shaft is pushed once. It takes the place of a push that the rig
/// file may conceal. Errors: those of openDrive(); a linear axis.
Result<std::unique_ptr<Drive>> openPushed(const std::string& uri, unsigned seed, const ShaftPush& push);

}  // namespace breakaway
