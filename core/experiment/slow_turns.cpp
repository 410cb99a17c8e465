#include "experiment/slow_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"

namespace breakaway {

SlowTurns::SlowTurns(SlowTurnsOptions options) : options_(std::move(options)), zeroing_(options_.zeroing_s) {
  const auto good = [](double speed) { return speed > 0.0; };
  if (options_.speeds_rad_per_s.empty() ||
      !std::all_of(options_.speeds_rad_per_s.begin(), options_.speeds_rad_per_s.end(), good))
    fail(message("no slow speed is asked for"));
}

double SlowTurns::target() const {
  const double speed = options_.speeds_rad_per_s[std::min(number_ / 2, options_.speeds_rad_per_s.size() - 1)];
  return number_ % 2 == 0 ? speed : -speed;
}

double SlowTurns::expected_s() const {
  return turn_rad / std::abs(target());
}

void SlowTurns::next(const Sample& sample) {
  start_s_ = sample.time_s;
  begun_ = false;
  current_A_rad_ = velocity_rad2_per_s_ = 0.0;
}

Command SlowTurns::run(const Sample& sample) {
  if (!zeroed_) {
    if (number_ == 0 && start_s_ == 0.0) start_s_ = sample.time_s;
    const Command command = zeroing_.step(sample, start_s_, zeroed_);
    if (zeroed_) next(sample);
    return command;
  }
  const double running_s = sample.time_s - start_s_ - options_.settle_s;
  if (running_s >= 0.0 && !begun_) {
    begun_ = true;
    startAngle_rad_ = lastAngle_rad_ = sample.angle_rad;
  }
  if (begun_) {
    const double step_rad = sample.angle_rad - std::exchange(lastAngle_rad_, sample.angle_rad);
    current_A_rad_ += sample.current_A * step_rad;
    velocity_rad2_per_s_ += sample.velocity_rad_per_s * step_rad;
    const double gone_rad = sample.angle_rad - startAngle_rad_;
    const bool whole = std::abs(gone_rad) >= turn_rad;
    if (whole) turns_.push_back({velocity_rad2_per_s_ / gone_rad, current_A_rad_ / gone_rad});
    if (whole || running_s > options_.patience * expected_s()) {
      next(sample);
      if (++number_ >= 2 * options_.speeds_rad_per_s.size()) finish();
    }
  }
  return {Command::Mode::velocity, target(), options_.current_limit_A, false};
}

TimedProcedure::Progress SlowTurns::progress() const {
  const size_t all = 2 * options_.speeds_rad_per_s.size();
  double left_s = 0.0;
  for (size_t k = number_; k < all; ++k) left_s += options_.settle_s + turn_rad / options_.speeds_rad_per_s[k / 2];
  return {std::min(1.0, static_cast<double>(number_) / static_cast<double>(all)), left_s, message("turning slowly")};
}

}  // namespace breakaway
