// Velocity and position control with disturbance feedback. Freestanding; the board runs it too.
#pragma once

#include "control/current_controller.h"

namespace breakaway {

/// Gains as in the bench file, contracts section 1.
template <typename Scalar>
struct MotionGains {
  Scalar velocity_kp_A_s_per_rad = 0;
  Scalar velocity_ki_A_per_rad = 0;
  Scalar velocity_kd_A_s2_per_rad = 0;
  Scalar position_kp_A_per_rad = 0;
  Scalar position_ki_A_per_rad_s = 0;
  Scalar position_kd_A_s_per_rad = 0;
  Scalar velocity_limit_rad_per_s = 0;  ///< of a position move; 0: none
  bool operator==(const MotionGains&) const = default;
};

/// PID whose output is held within ±limit_A; the integral holds while the output is at its limit and would go further.
/// `compensation_A` is the disturbance observer's τ̂/Ktn.
template <typename Scalar>
class MotionController {
 public:
  static constexpr Scalar slopeShare = Scalar(0.125);  ///< of a tick's new slope in the smoothed one

  void configure(const MotionGains<Scalar>& gains, Scalar tick_s) {
    gains_ = gains;
    tick_s_ = tick_s;
  }

  void reset(Scalar velocity_rad_per_s) {
    integral_A_ = slope_ = 0;
    velocity_ = velocity_rad_per_s;
  }

  /// i = kp·e + ki·∫e + kd·dė, e the speed's error; kd acts on the measured speed alone, smoothed over 8 ticks.
  Scalar velocityStep(Scalar reference_rad_per_s, Scalar velocity_rad_per_s, Scalar compensation_A, Scalar limit_A) {
    const Scalar error = reference_rad_per_s - velocity_rad_per_s;
    slope_ += slopeShare * ((velocity_rad_per_s - velocity_) / tick_s_ - slope_);
    velocity_ = velocity_rad_per_s;
    const Scalar direct = gains_.velocity_kp_A_s_per_rad * error - gains_.velocity_kd_A_s2_per_rad * slope_;
    return integrated(direct + compensation_A, gains_.velocity_ki_A_per_rad * error, limit_A);
  }

  /// i = kp·e + ki·∫e − kd·ω, e the angle's error; written as a speed kp/kd·e so that a long move keeps its speed
  /// limit.
  Scalar positionStep(Scalar error_rad, Scalar velocity_rad_per_s, Scalar compensation_A, Scalar limit_A) {
    velocity_ = velocity_rad_per_s;
    Scalar approach = gains_.position_kp_A_per_rad * error_rad;
    bool limited = false;
    if (gains_.velocity_limit_rad_per_s > Scalar(0)) {
      const Scalar most = gains_.position_kd_A_s_per_rad * gains_.velocity_limit_rad_per_s;
      limited = approach > most || approach < -most;
      approach = within(approach, most);
    }
    const Scalar growth = limited ? Scalar(0) : gains_.position_ki_A_per_rad_s * error_rad;
    return integrated(approach - gains_.position_kd_A_s_per_rad * velocity_rad_per_s + compensation_A, growth, limit_A);
  }

 private:
  Scalar integrated(Scalar direct_A, Scalar growth_A_per_s, Scalar limit_A) {
    const Scalar wanted = direct_A + integral_A_;
    const Scalar held = within(wanted, limit_A);
    if (wanted == held || (wanted - held) * growth_A_per_s < Scalar(0)) {
      integral_A_ = within(integral_A_ + growth_A_per_s * tick_s_, limit_A);
    }
    return held;
  }

  MotionGains<Scalar> gains_;
  Scalar tick_s_ = 1, integral_A_ = 0, slope_ = 0, velocity_ = 0;
};

}  // namespace breakaway
