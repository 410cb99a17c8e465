// Velocity and position control with disturbance feedback. Freestanding; the board runs it too.
#pragma once

#include "control/magnitude.h"

namespace breakaway {

/// Gains as in the bench file (resources/help/files.md).
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
    velocityGrowth_A_s_per_rad_ = gains.velocity_ki_A_per_rad * tick_s;
    positionGrowth_A_per_rad_ = gains.position_ki_A_per_rad_s * tick_s;
    slopeGain_A_s_per_rad_ = gains.velocity_kd_A_s2_per_rad / tick_s;
    mostApproach_A_ = gains.position_kd_A_s_per_rad * gains.velocity_limit_rad_per_s;
    if (slopeGain_A_s_per_rad_ == Scalar(0)) slope_ = 0;
  }

  void reset(Scalar velocity_rad_per_s) {
    integral_A_ = slope_ = 0;
    velocity_ = velocity_rad_per_s;
  }

  /// i = kp·e + ki·∫e + kd·dė, e the speed's error; kd acts on the measured speed alone, smoothed over 8 ticks.
  Scalar velocityStep(Scalar reference_rad_per_s, Scalar velocity_rad_per_s, Scalar compensation_A, Scalar limit_A) {
    const Scalar error = reference_rad_per_s - velocity_rad_per_s;
    Scalar direct = gains_.velocity_kp_A_s_per_rad * error + compensation_A;
    if (!isZero(slopeGain_A_s_per_rad_)) {
      slope_ += slopeShare * (velocity_rad_per_s - velocity_ - slope_);
      direct -= slopeGain_A_s_per_rad_ * slope_;
    }
    velocity_ = velocity_rad_per_s;
    return integrated(direct, velocityGrowth_A_s_per_rad_ * error, limit_A);
  }

  /// i = kp·e + ki·∫e − kd·ω, e the angle's error; written as a speed kp/kd·e so that a long move keeps its speed
  /// limit.
  Scalar positionStep(Scalar error_rad, Scalar velocity_rad_per_s, Scalar compensation_A, Scalar limit_A) {
    velocity_ = velocity_rad_per_s;
    Scalar approach = gains_.position_kp_A_per_rad * error_rad, growth = positionGrowth_A_per_rad_ * error_rad;
    if (isPositive(gains_.velocity_limit_rad_per_s) && exceeds(approach, mostApproach_A_)) {
      approach = within(approach, mostApproach_A_);
      growth = 0;
    }
    return integrated(approach - gains_.position_kd_A_s_per_rad * velocity_rad_per_s + compensation_A, growth, limit_A);
  }

 private:
  /// `growth_A` is the integral's in a tick.
  Scalar integrated(Scalar direct_A, Scalar growth_A, Scalar limit_A) {
    const Scalar wanted = direct_A + integral_A_;
    const bool limited = exceeds(wanted, limit_A);
    if (!isZero(growth_A) && (!limited || isNegative(wanted) != isNegative(growth_A)))
      integral_A_ = within(integral_A_ + growth_A, limit_A);
    return limited ? within(wanted, limit_A) : wanted;
  }

  MotionGains<Scalar> gains_;
  // What a tick would multiply is multiplied when the gains come; slopes are those of a tick.
  Scalar velocityGrowth_A_s_per_rad_ = 0, positionGrowth_A_per_rad_ = 0, slopeGain_A_s_per_rad_ = 0,
         mostApproach_A_ = 0;
  Scalar integral_A_ = 0, slope_ = 0, velocity_ = 0;
};

}  // namespace breakaway
