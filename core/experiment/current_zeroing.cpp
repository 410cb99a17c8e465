#include "experiment/current_zeroing.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

Command CurrentZeroing::run(const Sample& sample) {
  elapsed_s_ = elapsed_s(sample);
  if (elapsed_s_ < options_.settle_s || isFirst()) first_rad_ = sample.angle_rad;
  if (const double moved_rad = sample.angle_rad - first_rad_; std::abs(moved_rad) > options_.turns_rad) {
    fail(message(
        "{} moves {} by itself with the windings open: a load pulls it; hold or balance the load, or take it off",
        bodyText(options_.axis), wayText(moved_rad > 0.0, options_.axis)));
    return {};
  }
  if (elapsed_s_ < options_.settle_s) return {};
  if (!sample.enabled) {
    sum_ += sample.current_A;
    squares_ += sample.current_A * sample.current_A;
    ++count_;
    half_A_.take(sample);
  }
  if (!second_ && elapsed_s_ >= options_.settle_s + 0.5 * options_.duration_s) {
    second_ = true;
    half_A_.moved(options_.mostDrift_A);
  }
  if (elapsed_s_ >= options_.settle_s + options_.duration_s) {
    if (const Message moved = half_A_.moved(options_.mostDrift_A); !moved.empty()) fail(moved);
    finish();
    return {};
  }
  Command command;
  command.zeroCurrentSensor = true;
  return command;
}

Estimate CurrentZeroing::zero_A() const {
  if (count_ == 0) return {};
  const auto n = static_cast<double>(count_);
  return {sum_ / n, noiseRms_A() / std::sqrt(n)};
}

double CurrentZeroing::noiseRms_A() const {
  if (count_ < 2) return 0.0;
  const auto n = static_cast<double>(count_);
  return std::sqrt(std::max(0.0, (squares_ - sum_ * sum_ / n) / (n - 1.0)));
}

}  // namespace breakaway
