// The rotor's angle from what a VESC tells: an encoder's within its turn, or the commutation's steps.
#pragma once

#include <cstdint>
#include <optional>

namespace breakaway {

/// Unwraps an angle within the turn into one that grows without end, by the turn that comes nearest to where the speed
/// would have brought the rotor; so readings may lie more than half a turn apart.
class VescAngle {
 public:
  /// `within_rad` is in [0, 2π); the first one is taken as it is.
  double step(double within_rad, double velocity_rad_per_s, double time_s);

 private:
  std::optional<double> angle_rad_;
  double time_s_ = 0.0, velocity_rad_per_s_ = 0.0;
};

/// Six steps of the tachometer per pole pair and turn, as an angle.
double commutationAngle_rad(std::int32_t tachometer, double polePairs);

}  // namespace breakaway
