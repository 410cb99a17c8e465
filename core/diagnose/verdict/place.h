// A place where simulation and recording part.
#pragma once

#include <string>

#include "base/message.h"

namespace breakaway {

/// What a map of the unexplained goes along; `alongs`: the drive's frequency.
enum Along {
  byTime,
  byAngle,
  byVelocity,
  byAcceleration,
  byTorque,
  byReversal,
  byTemperature,
  byCurrent,
  bySpeedingUp,
  alongs
};

/// What a map of the unexplained shows. `friction` is the same torque counted along the motion: what resists whichever
/// way it goes.
enum class Unknown { torque, friction, voltage };

/// The part of the squared residual that what was learned on training data takes away from held-out data: torque, or
/// voltage. With its 95 % interval; 0 where nothing was held out that lies on the axis.
struct Foretold {
  double value = 0.0, low95 = 0.0, high95 = 0.0;
};

/// A stretch of one axis on which simulation and recording part.
struct Place {
  std::string axis;  ///< time, angle, velocity, acceleration, current, reversal, frequency, temperature
  double from = 0.0;
  double to = 0.0;
  std::string unit;
  double share = 0.0;
  double pValue = 1.0;
  Message sentence;
  double size = 0.0;            ///< mean of the unexplained there, as an absolute value
  std::string sizeUnit = "Nm";  ///< or N, or V
  Unknown shows = Unknown::torque;
  bool ofSomeSpeeds = false;  ///< it shows there at some speeds only
  Foretold foretells = {};
};

}  // namespace breakaway
