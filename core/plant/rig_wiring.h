// What is wrong at a simulated rig's terminals and on its shaft, as on many a bench's first day.
#pragma once

#include <string>
#include <vector>

#include "base/axis.h"

namespace breakaway {

class JsonObject;

enum class WiringKind {
  encoderReversed,  ///< counts the other way; so it does where the motor's leads are swapped as well as the bridge's
  encoderDead,      ///< neither counts nor index
  countsFactor,     ///< reported counts over true ones
  currentSensorReversed,  ///< about its zero
  currentSensorDead,      ///< reads exactly 0 A
  bridgeReversed,         ///< the winding gets the opposite voltage
  leadOff,                ///< no current flows
  supplyReadingFactor,    ///< the supply as it reads over what it is
  indexInverted,          ///< seen wherever it is not
  stopAt,                 ///< a stop on one side, at so many rad from where the shaft stood at power-up
  load,                   ///< constant, Nm towards growing angle
  pendulum                ///< gravity, Nm at most, hanging down where the shaft stood at power-up
};

/// One entry of a rig file's `wiring`, from from_s of rig time on. Angles and torques are on the rig's shaft.
struct RigWiring {
  WiringKind kind = WiringKind::encoderReversed;
  double from_s = 0.0;
  double value = 1.0;  ///< of those with a quantity in their name

  bool acts(double time_s) const { return time_s >= from_s; }
};

/// The field `wiring` of a rig file; none when it is missing. On a linear axis `stop_at_m` and `load_N` take the place
/// of `stop_at_rad` and `load_Nm`, one rad of the shaft being `unitPerRad`. What is wrong becomes a fault of `root`.
std::vector<RigWiring> readWiring(JsonObject& root, Axis axis, double unitPerRad);

/// The names that a rig file of that axis may hold.
std::vector<std::string> wiringNames(Axis axis);

}  // namespace breakaway
