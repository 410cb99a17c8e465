#include "diagnose/simulate/servo_drive.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr double shortestServoStep_s = 1e-3, longestStep_s = 2.5e-3;
constexpr double mostDamped = 0.25;   ///< of a step's velocity that the law may take away
constexpr double mostTimes = 1000.0;  ///< within a row

}  // namespace

std::optional<ServoDrive> ServoDrive::of(const Model& model) {
  if (!model.servo) return std::nullopt;
  const ServoNames& names = servoNames(model.input, model.axis);
  ServoDrive drive;
  drive.kp_ = model.baseValue(names.kp).value_or(0.0);
  drive.kd_ = model.baseValue(names.kd).value_or(0.0);
  drive.limit_ = model.baseValue(names.limit).value_or(0.0);
  drive.delay_s_ = model.baseValue(servoDelayName).value_or(0.0);
  drive.rate_Hz_ = model.servo->rate_Hz.value_or(0.0);
  drive.duty_ = model.input == DriveInput::duty;
  return drive;
}

double ServoDrive::late_s() const {
  return std::max(0.0, delay_s_) + (rate_Hz_ > 0.0 ? 0.5 / rate_Hz_ : 0.0);  // a held drive is half a hold late
}

double ServoDrive::input(const Track& track, size_t row, double from_s, double to_s, double position,
                         double velocity) const {
  const double reference = heldMean(track.time, track.reference, from_s - delay_s_, to_s - delay_s_, row);
  const double wantedVelocity = track.referenceSpeed.empty() ? 0.0
                                                             : heldMean(track.time, track.referenceSpeed,
                                                                        from_s - delay_s_, to_s - delay_s_, row);
  double drive = kp_ * (reference - position) - kd_ * (velocity - wantedVelocity);
  if (limit_ > 0.0) drive = std::clamp(drive, -limit_, limit_);
  if (duty_) drive = std::clamp(drive, -1.0, 1.0) * track.supplyAt(row);
  return drive + (track.push.empty() ? 0.0 : track.push[row]);
}

double ServoDrive::stiffness(const Track& track, size_t row, double drive) const {
  const double unit = duty_ ? track.supplyAt(row) : 1.0;
  const double most = duty_ ? std::min(1.0, limit_ > 0.0 ? limit_ : 1.0) : limit_;
  return most > 0.0 && std::abs(drive) >= most * unit ? 0.0 : kp_ * unit;
}

double ServoDrive::damping(const Track& track, size_t row, double drive) const {
  return kp_ > 0.0 ? stiffness(track, row, drive) * kd_ / kp_ : 0.0;
}

size_t ServoDrive::times(double dt, double inertia, double torquePerInput) const {
  const double longest_s = std::clamp(2.0 * late_s(), shortestServoStep_s, longestStep_s);
  const double stable = kd_ * torquePerInput * dt / (mostDamped * std::max(inertia, 1e-300));
  return static_cast<size_t>(std::clamp(std::ceil(std::max(dt / longest_s, stable) - 1e-6), 1.0, mostTimes));
}

}  // namespace breakaway
