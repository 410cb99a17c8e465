#include "firmware_link/vesc/vesc_angle.h"

#include <cmath>

#include "base/numbers.h"

namespace breakaway {

double VescAngle::step(double within_rad, double velocity_rad_per_s, double time_s) {
  if (!angle_rad_) {
    angle_rad_ = within_rad;
  } else {
    const double mean_rad_per_s = 0.5 * (velocity_rad_per_s + velocity_rad_per_s_);
    const double expected_rad = *angle_rad_ + mean_rad_per_s * (time_s - time_s_);
    angle_rad_ = within_rad + turn_rad * std::round((expected_rad - within_rad) / turn_rad);
  }
  time_s_ = time_s;
  velocity_rad_per_s_ = velocity_rad_per_s;
  return *angle_rad_;
}

double commutationAngle_rad(std::int32_t tachometer, double polePairs) {
  return tachometer * turn_rad / (6.0 * polePairs);
}

}  // namespace breakaway
