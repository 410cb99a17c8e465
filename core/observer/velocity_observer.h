// Speed from encoder counts: a third-order Luenberger observer. Freestanding; the board runs it too.
#pragma once

namespace breakaway {

/// The gains that place all three poles of the error at p = 1/(1 + wT) exactly: 1 − wT for small wT, yet stable for
/// any.
template <typename Scalar>
struct VelocityObserverGains {
  Scalar angle = 0, velocity_per_s = 0, acceleration_per_s2 = 0;

  static constexpr VelocityObserverGains placed(Scalar bandwidth_rad_per_s, Scalar tick_s) {
    const Scalar p = Scalar(1) / (Scalar(1) + bandwidth_rad_per_s * tick_s), q = Scalar(1) - p;
    return {Scalar(1) - p * p * p, Scalar(1.5) * q * q * (Scalar(1) + p) / tick_s, q * q * q / (tick_s * tick_s)};
  }
};

/// Follows angle, speed and acceleration with all three poles of the error at the bandwidth w, driven by the known
/// torque's change: θ̂' = ω̂ + 3w·e, ω̂' = â + 3w²·e, â' = w³·e, and â takes the change of Ktn·i/Jn at once. A constant
/// acceleration leaves no error. Of the encoder's rounding it passes about q·w·√(w·T), q the rounding's rms, where the
/// backward difference passes 1.4·q/T.
template <typename Scalar>
class VelocityObserver {
 public:
  void configure(Scalar bandwidth_rad_per_s, Scalar torquePerInertia_rad_per_A_s2, Scalar tick_s) {
    torquePerInertia_ = torquePerInertia_rad_per_A_s2;
    tick_s_ = tick_s;
    gains_ = VelocityObserverGains<Scalar>::placed(bandwidth_rad_per_s, tick_s);
  }

  void reset(Scalar angle_rad) {
    angle_ = angle_rad;
    velocity_ = acceleration_ = current_ = 0;
  }

  /// `angle_rad` is the middle of the encoder's count; `current_A` what flowed over the last tick, 0 when unknown.
  Scalar step(Scalar angle_rad, Scalar current_A) {
    acceleration_ += torquePerInertia_ * (current_A - current_);
    current_ = current_A;
    angle_ += tick_s_ * (velocity_ + Scalar(0.5) * tick_s_ * acceleration_);
    velocity_ += tick_s_ * acceleration_;
    const Scalar error = angle_rad - angle_;
    angle_ += gains_.angle * error;
    velocity_ += gains_.velocity_per_s * error;
    acceleration_ += gains_.acceleration_per_s2 * error;
    return velocity_;
  }

  Scalar velocity_rad_per_s() const { return velocity_; }
  /// Shifts the angle's zero, so that a single-precision board can keep it small.
  void shift(Scalar by_rad) { angle_ += by_rad; }

 private:
  Scalar torquePerInertia_ = 0, tick_s_ = 1;
  VelocityObserverGains<Scalar> gains_;
  Scalar angle_ = 0, velocity_ = 0, acceleration_ = 0, current_ = 0;
};

}  // namespace breakaway
