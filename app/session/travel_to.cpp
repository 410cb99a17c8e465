#include "session/travel_to.h"

#include <cmath>

namespace breakaway {

namespace {

constexpr double travelPatience = 2.0, travelGrace_s = 2.0;  // over the time that the way takes

}  // namespace

Command TravelTo::run(const Sample& sample) {
  left_m_ = std::abs(target_m_ - sample.angle_rad);
  if (isFirst()) {
    start_m_ = left_m_;
    allowed_s_ = travelGrace_s + travelPatience * left_m_ / glide_.speed_m_per_s();
  }
  if (left_m_ < tolerance_m_) {
    finish();
  } else if (elapsed_s(sample) > allowed_s_) {
    fail("the axis does not reach the place where this begins; is it held, or the current limit too low?");
  }
  return {Command::Mode::velocity, glide_.next(sample.angle_rad, target_m_, tick_s()), 0.0, false};
}

}  // namespace breakaway
