// Disturbance observer: the load torque from current and speed, without a differentiator. Freestanding; the board runs
// it too.
#pragma once

namespace breakaway {

/// e^x for x ≤ 0 without a library, for boards that have none: e^x = (e^(x/2ⁿ))^(2ⁿ), series within |x/2ⁿ| ≤ 1/8.
template <typename Scalar>
constexpr Scalar exponential(Scalar x) {
  int halvings = 0;
  while (x < Scalar(-0.125) && halvings < 60) {
    x /= Scalar(2);
    ++halvings;
  }
  Scalar sum = 1, term = 1;
  for (int k = 1; k <= 12; ++k) {
    term *= x / Scalar(k);
    sum += term;
  }
  while (halvings-- > 0) sum *= sum;
  return sum;
}

/// Plant Jn·dω/dt = Ktn·i − τ. The estimate is τ̂ = g/(s+g)·[Ktn·i + g·Jn·ω] − g·Jn·ω, in Nm, positive against growing
/// angle; it holds load, friction, position torque and the mismatch of Jn and Ktn. Sampled with the exact pole e^{−gT}:
/// exact for inputs held over a tick. Source: Ohnishi, Shibata, Murakami, "Motion control for advanced mechatronics",
/// IEEE/ASME Trans. Mechatronics 1(1), 1996, eqs. 6 to 9. Feed it the measured or the saturated current, never the one
/// wished for.
template <typename Scalar>
class DisturbanceObserver {
 public:
  struct Settings {
    Scalar cutoff_rad_per_s = 0;
    Scalar inertia_kg_m2 = 0;
    Scalar torqueConstant_Nm_per_A = 0;
  };

  /// Keeps the present estimate, so that a change of cutoff while running gives no jump of its own.
  void configure(const Settings& settings, Scalar tick_s) {
    torqueConstant_ = settings.torqueConstant_Nm_per_A;
    momentum_ = settings.cutoff_rad_per_s * settings.inertia_kg_m2;
    share_ = Scalar(1) - exponential<Scalar>(-settings.cutoff_rad_per_s * tick_s);
    state_ = estimate_Nm_ + momentum_ * velocity_;
  }

  /// Starts again from zero load at the present speed.
  void reset(Scalar velocity_rad_per_s) {
    velocity_ = velocity_rad_per_s;
    estimate_Nm_ = 0;
    state_ = momentum_ * velocity_rad_per_s;
  }

  /// Once per tick; returns τ̂ in Nm.
  Scalar step(Scalar current_A, Scalar velocity_rad_per_s) {
    const Scalar momentum = momentum_ * velocity_rad_per_s;
    state_ += share_ * (torqueConstant_ * current_A + momentum - state_);
    velocity_ = velocity_rad_per_s;
    estimate_Nm_ = state_ - momentum;
    return estimate_Nm_;
  }

  Scalar estimate_Nm() const { return estimate_Nm_; }

 private:
  Scalar torqueConstant_ = 0, momentum_ = 0, share_ = 0;  ///< momentum: g·Jn; share: 1 − e^(−gT)
  Scalar state_ = 0, velocity_ = 0, estimate_Nm_ = 0;
};

}  // namespace breakaway
