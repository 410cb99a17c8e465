// Reaction torque observer: the disturbance observer with the friction that is known taken out of it. Freestanding; the
// board runs it too.
#pragma once

#include "observer/disturbance_observer.h"

namespace breakaway {

/// F·sgn ω + D·ω in Nm, positive against growing angle; 0·F at standstill. F in Nm, D in Nm s/rad.
template <typename Scalar>
constexpr Scalar dryAndViscous(Scalar coulomb_Nm, Scalar viscous_Nm_s_per_rad, Scalar velocity_rad_per_s) {
  const Scalar way = velocity_rad_per_s > Scalar(0)   ? Scalar(1)
                     : velocity_rad_per_s < Scalar(0) ? Scalar(-1)
                                                      : Scalar(0);
  return coulomb_Nm * way + viscous_Nm_s_per_rad * velocity_rad_per_s;
}

/// What is left of the load torque without friction and without the nominal values' errors:
/// τ̂ = g/(s+g)·[(Ktn+ΔKt)·i + g·(Jn+ΔJ)·ω − τ_friction] − g·(Jn+ΔJ)·ω, in Nm, positive against growing angle. All that
/// is subtracted stands inside the bracket, so that nothing is differentiated and everything passes the same filter.
/// Source: Murakami, Yu, Ohnishi, "Torque sensorless control in multidegree-of-freedom manipulator", IEEE Trans.
/// Industrial Electronics 40(2), 1993. Sampled with the exact pole e^{−gT}.
template <typename Scalar>
class ReactionTorqueObserver {
 public:
  struct Settings {
    typename DisturbanceObserver<Scalar>::Settings nominal;
    Scalar inertiaMismatch_kg_m2 = 0;            ///< J − Jn
    Scalar torqueConstantMismatch_Nm_per_A = 0;  ///< Kt − Ktn
  };

  void configure(const Settings& settings, Scalar tick_s) {
    torqueConstant_ = settings.nominal.torqueConstant_Nm_per_A + settings.torqueConstantMismatch_Nm_per_A;
    observer_.configure(
        {settings.nominal.cutoff_rad_per_s, settings.nominal.inertia_kg_m2 + settings.inertiaMismatch_kg_m2, Scalar(1)},
        tick_s);
  }

  void reset(Scalar velocity_rad_per_s) { observer_.reset(velocity_rad_per_s); }

  /// Once per tick; `friction_Nm` is the model's torque of this tick, positive against growing angle. Returns τ̂ in Nm.
  Scalar step(Scalar current_A, Scalar velocity_rad_per_s, Scalar friction_Nm) {
    return observer_.step(torqueConstant_ * current_A - friction_Nm, velocity_rad_per_s);
  }

  Scalar estimate_Nm() const { return observer_.estimate_Nm(); }

 private:
  DisturbanceObserver<Scalar> observer_;  // of a motor with 1 Nm/A: it is fed torques
  Scalar torqueConstant_ = 0;
};

}  // namespace breakaway
