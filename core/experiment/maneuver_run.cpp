#include "experiment/maneuver_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace breakaway {

namespace {

constexpr double zeroing_s = 0.5;
constexpr double mostStalled_s = 2.0;  // at a speed that should be there
constexpr double partOfLimit = 0.9;    // so that overshoot stays within

double limited(double value, double limit) {
  return limit > 0.0 ? std::clamp(value, -limit, limit) : value;
}

}  // namespace

ManeuverRun::ManeuverRun(Maneuver motion, const ManeuverLimits& limits, bool zeroes, Axis axis)
    : motion_(std::move(motion)),
      limits_(limits),
      axis_(axis),
      zeroing_s_(zeroes ? zeroing_s : 0.0),
      whole_s_(zeroing_s_ + durationOf(motion_)),
      begun_s_(zeroing_s_) {
  limits_.speed *= partOfLimit;
  if (motion_.empty()) fail(message("the experiment holds no motion"));
}

Command ManeuverRun::run(const Sample& sample) {
  elapsed_s_ = elapsed_s(sample);
  if (isFirst()) movedAngle_ = sample.angle_rad;
  if (elapsed_s_ < zeroing_s_) {
    Command command;
    command.zeroCurrentSensor = elapsed_s_ > 0.1 * zeroing_s_;
    return command;
  }
  while (at_ < motion_.size() && elapsed_s_ - begun_s_ >= motion_[at_].duration_s) {
    begun_s_ += motion_[at_].duration_s;
    ++at_;
  }
  if (at_ >= motion_.size()) {
    finish();
    return {};
  }
  const Command command = follow(motion_[at_], elapsed_s_ - begun_s_, sample);
  watchMotion(command, sample);
  return command;
}

Command ManeuverRun::follow(const ManeuverStretch& stretch, double time_s, const Sample& sample) {
  double wanted = way_ * stretch.at(time_s);
  if (const auto& travel = limits_.travel) {
    const double speed = sample.velocity_rad_per_s;
    const double way = limits_.braking > 0.0 ? 0.5 * speed * std::abs(speed) / limits_.braking : 0.0;
    const double stops = sample.angle_rad + way;
    const double beyond = stops > travel->last_m() ? 1.0 : stops < travel->first_m() ? -1.0 : 0.0;
    if (beyond * wanted > 0.0) way_ = -way_, wanted = -wanted;
    // A current might not brake enough.
    if (beyond * speed > 0.0 && stretch.of == ManeuverStretch::Of::current) return {Command::Mode::velocity, 0.0};
  }
  if (stretch.of == ManeuverStretch::Of::speed) return {Command::Mode::velocity, limited(wanted, limits_.speed)};
  const bool faster = limits_.speed > 0.0 && std::abs(sample.velocity_rad_per_s) > limits_.speed &&
                      wanted * sample.velocity_rad_per_s > 0.0;
  return {Command::Mode::current, faster ? 0.0 : limited(wanted, limits_.current_A)};
}

void ManeuverRun::watchMotion(const Command& command, const Sample& sample) {
  if (sample.angle_rad != movedAngle_ || command.mode != Command::Mode::velocity || command.target == 0.0) {
    movedAngle_ = sample.angle_rad;
    stalled_s_ = 0.0;
    return;
  }
  if ((stalled_s_ += tick_s()) > mostStalled_s) fail(message("{} does not move, though it should", bodyText(axis_)));
}

}  // namespace breakaway
