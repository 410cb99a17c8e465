#include "session/jog.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace breakaway {

namespace {

constexpr double speedUp_s = 0.2;
constexpr double patience = 3.0, grace_s = 2.0;  // over the time that the way takes
constexpr double nearPart = 0.01;                // of the step
constexpr double nearCounts = 2.0;

}  // namespace

Jog::Jog(const JogOptions& options, std::shared_ptr<HandGrip> grip)
    : options_(options), grip_(std::move(grip)), glide_(options.speed_rad_per_s, options.speed_rad_per_s / speedUp_s) {
}

Command Jog::run(const Sample& sample) {
  if (isFirst()) {
    target_rad_ = sample.angle_rad + options_.by_rad;
    if (options_.travel) target_rad_ = std::clamp(target_rad_, options_.travel->first_m(), options_.travel->last_m());
    way_rad_ = std::abs(target_rad_ - sample.angle_rad);
    allowed_s_ = grace_s + patience * way_rad_ / options_.speed_rad_per_s;
  }
  left_rad_ = std::abs(target_rad_ - sample.angle_rad);
  const double near_rad = std::max(nearPart * std::abs(options_.by_rad), nearCounts * options_.count_rad);
  if (!grip_->held || left_rad_ <= near_rad) {
    finish();
  } else if (options_.mostSpeed_rad_per_s > 0.0 && std::abs(sample.velocity_rad_per_s) > options_.mostSpeed_rad_per_s) {
    fail(message("faster than the limit on the page: let go"));
  } else if (elapsed_s(sample) > allowed_s_) {
    fail(message("the step does not arrive; is the shaft held, or the current limit too low?"));
  }
  return {Command::Mode::velocity, glide_.next(sample.angle_rad, target_rad_, tick_s()), options_.most_A, false};
}

TimedProcedure::Progress Jog::progress() const {
  return {way_rad_ > 0.0 ? 1.0 - std::min(1.0, left_rad_ / way_rad_) : 1.0, left_rad_ / options_.speed_rad_per_s,
          message("one step by hand")};
}

}  // namespace breakaway
