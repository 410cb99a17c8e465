// A place where simulation and recording part.
#pragma once

#include <string>

namespace breakaway {

/// What a map of the unexplained shows. `friction` is the same torque counted along the motion: what resists whichever
/// way it goes.
enum class Unknown { torque, friction, voltage };

/// A stretch of one axis on which simulation and recording part.
struct Place {
  std::string axis;  ///< time, angle, velocity, acceleration, current, reversal, frequency, temperature
  double from = 0.0;
  double to = 0.0;
  std::string unit;
  double share = 0.0;
  double pValue = 1.0;
  std::string sentence;
  double size = 0.0;            ///< mean of the unexplained there, as an absolute value
  std::string sizeUnit = "Nm";  ///< or N, or V
  Unknown shows = Unknown::torque;
  bool ofSomeSpeeds = false;  ///< it shows there at some speeds only
};

}  // namespace breakaway
