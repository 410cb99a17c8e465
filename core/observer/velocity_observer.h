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
    // States are per tick: in a tick they are added and not multiplied.
    const Scalar before = perTick_ > Scalar(0) ? tick_s * perTick_ : Scalar(1);
    velocity_ *= before;
    halfAcceleration_ *= before * before;
    perTick_ = Scalar(1) / tick_s;
    const auto gains = VelocityObserverGains<Scalar>::placed(bandwidth_rad_per_s, tick_s);
    halfPush_ = Scalar(0.5) * torquePerInertia_rad_per_A_s2 * tick_s * tick_s;
    leftOfError_ = Scalar(1) - gains.angle;
    velocityGain_ = gains.velocity_per_s * tick_s;
    halfAccelerationGain_ = Scalar(0.5) * gains.acceleration_per_s2 * tick_s * tick_s;
  }

  void reset(Scalar angle_rad) {
    angle_ = angle_rad;
    error_ = velocity_ = halfAcceleration_ = current_ = 0;
  }

  /// `angle_rad` is the middle of the encoder's count; `current_A` what flowed over the last tick, 0 when unknown.
  Scalar step(Scalar angle_rad, Scalar current_A) {
    halfAcceleration_ += halfPush_ * (current_A - current_);
    current_ = current_A;
    const Scalar moved = velocity_ + halfAcceleration_, seen = angle_rad - angle_;
    angle_ = angle_rad;
    const Scalar error = leftOfError_ * error_ + (seen - moved);
    error_ = error;
    velocity_ = moved + halfAcceleration_ + velocityGain_ * error;
    halfAcceleration_ += halfAccelerationGain_ * error;
    return velocity_rad_per_s();
  }

  Scalar velocity_rad_per_s() const { return velocity_ * perTick_; }
  /// Shifts the angle's zero, so that a single-precision board can keep it small.
  void shift(Scalar by_rad) { angle_ += by_rad; }

 private:
  Scalar halfPush_ = 0, leftOfError_ = 0, velocityGain_ = 0, halfAccelerationGain_ = 0, perTick_ = 0;
  // The angle is the last measured one, the error what the estimate was behind it before it was corrected; rad, rad per
  // tick, rad per tick².
  Scalar angle_ = 0, error_ = 0, velocity_ = 0, halfAcceleration_ = 0, current_ = 0;
};

}  // namespace breakaway
