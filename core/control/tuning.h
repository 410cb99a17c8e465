// Gains from the identified motor.
#pragma once

#include "control/motion_controller.h"

namespace breakaway {

/// Velocity PI with disturbance feedback: kp = J·w/Kt puts the closed loop's pole at −w; the observer takes the
/// integral's part, so ki is small. Position: critically damped at w_p, kp = J·w_p²/Kt, kd = 2·J·w_p/Kt. SI; w in
/// rad/s.
template <typename Scalar>
MotionGains<Scalar> tuneMotion(Scalar inertia_kg_m2, Scalar torqueConstant_Nm_per_A, Scalar velocityBandwidth_rad_per_s,
                               Scalar positionBandwidth_rad_per_s) {
  const Scalar perTorque = inertia_kg_m2 / torqueConstant_Nm_per_A;
  MotionGains<Scalar> gains;
  gains.velocity_kp_A_s_per_rad = perTorque * velocityBandwidth_rad_per_s;
  gains.position_kp_A_per_rad = perTorque * positionBandwidth_rad_per_s * positionBandwidth_rad_per_s;
  gains.position_kd_A_s_per_rad = Scalar(2) * perTorque * positionBandwidth_rad_per_s;
  return gains;
}

/// Bandwidths that the boards run their speed observer and their current loop with: 400 and 300 rad/s, less where the
/// tick is too slow for them.
template <typename Scalar>
constexpr Scalar boardVelocityBandwidth_rad_per_s(Scalar tick_s) {
  const Scalar sampled = Scalar(0.4) / tick_s;
  return sampled < Scalar(400) ? sampled : Scalar(400);
}
template <typename Scalar>
constexpr Scalar boardCurrentBandwidth_rad_per_s(Scalar tick_s) {
  const Scalar sampled = Scalar(0.2) / tick_s;
  return sampled < Scalar(300) ? sampled : Scalar(300);
}

/// What a board takes for these two: from a tenth of its own on, up to where speed observer and current loop stay sound
/// with a tick of delay in between.
template <typename Scalar>
struct BandwidthRange {
  Scalar least_rad_per_s = 0, most_rad_per_s = 0;
};
template <typename Scalar>
constexpr BandwidthRange<Scalar> velocityBandwidthRange(Scalar tick_s) {
  return {Scalar(0.1) * boardVelocityBandwidth_rad_per_s(tick_s), Scalar(1) / tick_s};
}
template <typename Scalar>
constexpr BandwidthRange<Scalar> currentBandwidthRange(Scalar tick_s) {
  return {Scalar(0.1) * boardCurrentBandwidth_rad_per_s(tick_s), Scalar(0.5) / tick_s};
}

/// The observer cutoff that keeps αgT ≤ 0.3 and the damping ζ = ½√(g_v/(αg)) ≥ 0.707 behind a speed filter of g_v, α
/// = 1.
template <typename Scalar>
Scalar tuneObserver(Scalar tick_s, Scalar velocityFilter_rad_per_s) {
  const Scalar sampled = Scalar(0.3) / tick_s, damped = Scalar(0.5) * velocityFilter_rad_per_s;
  const Scalar most = sampled < damped ? sampled : damped;
  return most < Scalar(200) ? most : Scalar(200);
}

}  // namespace breakaway
