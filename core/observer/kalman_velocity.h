// Speed and load torque from encoder counts and current by a stationary Kalman filter. Freestanding; the board runs it
// too.
#pragma once

#include "observer/riccati.h"

namespace breakaway {

/// State angle, speed, load torque; J·dω/dt = Kt·i − τ, τ a random walk. Measured: the angle, rounded to counts, taken
/// as white with variance count²/12; the current, which drives the model, with its noise. The gain is that of the
/// stationary filter, from the discrete Riccati equation, computed in configure() in units of counts and ticks, where
/// all entries are near one. Source: Kalman, "A new approach to linear filtering and prediction problems", J. Basic
/// Eng. 82, 1960; the load as a state: Belanger, "Estimation of angular velocity and acceleration from shaft encoder
/// measurements", ICRA 1992.
template <typename Scalar>
class KalmanVelocity {
 public:
  struct Settings {
    Scalar inertia_kg_m2 = 0;
    Scalar torqueConstant_Nm_per_A = 0;
    Scalar count_rad = 0;
    Scalar loadWalk_Nm_per_sqrt_s = 0;  ///< how fast the load wanders, > 0
    Scalar currentNoise_A = 0;          ///< rms per tick
  };

  /// All settings positive, the current's noise may be 0.
  void configure(const Settings& settings, Scalar tick_s) {
    settings_ = settings;
    tick_s_ = tick_s;
    perTorque_ = tick_s * tick_s / (settings.inertia_kg_m2 * settings.count_rad);
    const Scalar noise = perTorque_ * settings.torqueConstant_Nm_per_A * settings.currentNoise_A;
    const Scalar walk = perTorque_ * settings.loadWalk_Nm_per_sqrt_s;
    const Scalar byCurrent[3] = {Scalar(0.5), Scalar(1), Scalar(0)};
    Matrix3<Scalar> Q;  // of a tick, by the current's noise and the load's walk
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) Q.at[i][j] = noise * noise * byCurrent[i] * byCurrent[j];
    }
    Q.at[2][2] += walk * walk * tick_s;
    const Matrix3<Scalar> F{{{1, 1, Scalar(-0.5)}, {0, 1, -1}, {0, 0, 1}}};
    const Scalar r = Scalar(1) / Scalar(12);
    const Matrix3<Scalar> P = stationaryCovariance(F, Q, r);
    for (int i = 0; i < 3; ++i) {
      gain_[i] = P.at[i][0] / (P.at[0][0] + r);
      variance_[i] = P.at[i][i] - gain_[i] * P.at[0][i];
    }
  }

  void reset(Scalar angle_rad) {
    state_[0] = angle_rad / settings_.count_rad;
    state_[1] = state_[2] = 0;
  }

  /// `angle_rad` is the middle of the encoder's count, `current_A` what flowed over the last tick. Returns the speed.
  Scalar step(Scalar angle_rad, Scalar current_A) {
    const Scalar push = perTorque_ * settings_.torqueConstant_Nm_per_A * current_A - state_[2];
    state_[0] += state_[1] + Scalar(0.5) * push;
    state_[1] += push;
    const Scalar innovation = angle_rad / settings_.count_rad - state_[0];
    for (int i = 0; i < 3; ++i) state_[i] += gain_[i] * innovation;
    return velocity_rad_per_s();
  }

  Scalar velocity_rad_per_s() const { return state_[1] * settings_.count_rad / tick_s_; }
  /// The load torque, positive against growing angle.
  Scalar load_Nm() const { return state_[2] / perTorque_; }
  /// Variances that the filter expects of its own speed, in rad²/s², and load, in Nm², once it has settled.
  Scalar velocityVariance() const {
    const Scalar unit = settings_.count_rad / tick_s_;
    return variance_[1] * unit * unit;
  }
  Scalar loadVariance() const { return variance_[2] / (perTorque_ * perTorque_); }
  /// Stationary gain on angle, speed and load, in counts and ticks.
  Scalar gain(int state) const { return gain_[state]; }

 private:
  Settings settings_;
  Scalar tick_s_ = 1, perTorque_ = 1;
  Scalar gain_[3] = {}, variance_[3] = {}, state_[3] = {};  // angle, speed, load, in counts and ticks
};

}  // namespace breakaway
