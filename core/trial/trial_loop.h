// The controller of a sealed trial's rig, at the row rate, in torque.
#pragma once

#include "trial/trial_rig.h"

namespace breakaway {

/// Gains in Nm, for a nominal inertia J and bandwidth w: velocity loop kp = J w, ki = J w²/6; position loop
/// kp = 1.2 J w², kd = 1.6 J w, ki = J w³/8.
struct TrialGains {
  double kp = 0.0, ki = 0.0, kd = 0.0;
};
TrialGains gainsOf(const TrialRig& rig);

/// Velocity PI or position PID with an optional disturbance observer (K. Ohnishi, M. Shibata, T. Murakami, "Motion
/// control for advanced mechatronics", IEEE/ASME Trans. Mechatronics 1 (1996)).
class TrialController {
 public:
  explicit TrialController(const TrialRig& rig);

  /// The torque to ask for in this row, Nm.
  double torque(double shownPosition, double positionReference, double velocityReference);
  /// Speed as the controller sees it: the encoder's difference behind a first-order lag, rad/s.
  double velocity() const { return velocity_; }

 private:
  TrialLoop loop_;
  TrialGains gains_;
  double inertia_, limit_, row_s_, forget_;
  bool first_ = true;
  double last_ = 0.0, velocity_ = 0.0, integral_ = 0.0, observed_ = 0.0, torque_ = 0.0;
};

}  // namespace breakaway
