#include "trial/trial_loop.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

TrialGains gainsOf(const TrialRig& rig) {
  const double w = rig.loop.bandwidth_rad_per_s, J = rig.physics.totalInertia();
  if (rig.loop.mode == ControlMode::openLoop) return {};
  if (rig.loop.mode == ControlMode::velocity) return {J * w, J * w * w / 6.0, 0.0};
  return {1.2 * J * w * w, J * w * w * w / 8.0, 1.6 * J * w};
}

TrialController::TrialController(const TrialRig& rig)
    : loop_(rig.loop),
      gains_(gainsOf(rig)),
      inertia_(rig.physics.totalInertia()),
      limit_(rig.peakTorque),
      row_s_(rig.sensors.row_s),
      forget_(1.0 - std::exp(-row_s_ *
                             std::max(8.0 * rig.loop.bandwidth_rad_per_s, 1.5 * rig.loop.observerCutoff_rad_per_s))) {
}

double TrialController::torque(double shownPosition, double positionReference, double velocityReference) {
  if (first_) last_ = shownPosition;
  first_ = false;
  velocity_ += forget_ * ((shownPosition - last_) / row_s_ - velocity_);
  last_ = shownPosition;
  const double velocityError = velocityReference - velocity_;
  const bool position = loop_.mode == ControlMode::position;
  const double error = position ? positionReference - shownPosition : velocityError;
  const double wanted = gains_.kp * error + gains_.kd * (position ? velocityError : 0.0) + gains_.ki * integral_;
  double disturbance = 0.0;
  if (const double g = loop_.observerCutoff_rad_per_s; g > 0.0) {
    // Low-passed (torque + g J velocity) minus g J velocity is what the loop must add.
    observed_ += (1.0 - std::exp(-g * row_s_)) * (torque_ + g * inertia_ * velocity_ - observed_);
    disturbance = observed_ - g * inertia_ * velocity_;
  }
  const double asked = wanted + disturbance;
  torque_ = std::clamp(asked, -limit_, limit_);
  if (asked == torque_ || error * asked < 0.0) integral_ += error * row_s_;
  return torque_;
}

}  // namespace breakaway
