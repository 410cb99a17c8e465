// The controller's own code around a linear motor that is integrated by Runge and Kutta: nothing of the stability room
// takes part.
#pragma once

#include <array>
#include <cmath>
#include <deque>

#include "base/random.h"
#include "control/servo_controller.h"
#include "stability/servo_loop.h"

namespace breakaway::test {

/// Winding, shaft, and ServoController, with neither encoder steps nor limits that are ever reached.
class SimulatedLoop {
 public:
  /// The encoder shows `encoderGain` times the angle.
  explicit SimulatedLoop(const ServoLoop& loop, double encoderGain = 1.0)
      : loop_(loop), controller_(loop.board), encoderGain_(encoderGain) {
    loop_.settings.current_limit_A = 1e12;
    controller_.configure(loop_.settings);
    controller_.command({loop.mode, 0.0, 0.0, false});
    waiting_.assign(static_cast<size_t>(loop.delay_ticks), 0.0);
  }

  void push(double velocity_rad_per_s) { state_[1] += velocity_rad_per_s; }
  void ask(double target) { controller_.command({loop_.mode, target, 0.0, false}); }

  /// One tick; the errors are added to what the sensors show.
  ServoOutput<double> step(double angleError_rad = 0.0, double currentError_A = 0.0, double load_Nm = 0.0) {
    const auto out = controller_.step(encoderGain_ * state_[2] + angleError_rad, state_[0] + currentError_A, 1e12);
    waiting_.push_back(out.voltage_V);
    const double voltage = waiting_.front();
    waiting_.pop_front();
    for (int k = 0; k < 4; ++k) advance(0.25 * loop_.board.tick_s, voltage, load_Nm);
    return out;
  }

  double velocity_rad_per_s() const { return state_[1]; }
  double angle_rad() const { return state_[2]; }

 private:
  using Three = std::array<double, 3>;  // current, speed, angle

  Three slope(const Three& x, double voltage, double load) const {
    const LoopMotor& m = loop_.motor;
    return {(voltage - m.resistance_ohm * x[0] - m.backEmfConstant_V_s_per_rad * x[1]) / m.inductance_H,
            (m.torqueConstant_Nm_per_A * x[0] - m.viscous_Nm_s_per_rad * x[1] - load) / m.inertia_kg_m2, x[1]};
  }

  static Three along(const Three& x, const Three& k, double h) {
    return {x[0] + h * k[0], x[1] + h * k[1], x[2] + h * k[2]};
  }

  void advance(double h, double voltage, double load) {
    const Three a = slope(state_, voltage, load), b = slope(along(state_, a, 0.5 * h), voltage, load),
                c = slope(along(state_, b, 0.5 * h), voltage, load), d = slope(along(state_, c, h), voltage, load);
    for (size_t k = 0; k < 3; ++k) state_[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
  }

  ServoLoop loop_;
  ServoController<double> controller_;
  double encoderGain_;
  std::deque<double> waiting_;
  Three state_{};
};

/// Whether a push grows instead of dying out; rounding, which never dies out, is no growth.
inline bool grows(const ServoLoop& loop, double encoderGain = 1.0) {
  const int ticks = 24000;
  SimulatedLoop simulated(loop, encoderGain);
  simulated.push(1e-3);
  double before = 0.0, after = 0.0;
  for (int k = 0; k < ticks; ++k) {
    simulated.step();
    const double speed = simulated.velocity_rad_per_s();
    if (!(std::abs(speed) < 1e9)) return true;
    if (k >= ticks / 3) (k < 2 * ticks / 3 ? before : after) += speed * speed;
  }
  return after > before && after > 1e-12 * ticks * 1e-6;
}

/// The preset servo's board and motor at a tick of T, its motor answering α times as fast as the controller believes.
inline ServoLoop servoLoop(double alpha, double tick_s, int delay_ticks) {
  const double J = 6e-5, Kt = 0.07;
  ServoLoop loop;
  loop.motor = {J / alpha, Kt, 2e-5, 1.2, 0.0011, Kt};
  loop.board = {tick_s, 0.0, {1.2, 0.0011, Kt, std::min(300.0, 0.2 / tick_s)}, std::min(400.0, 0.4 / tick_s)};
  loop.settings.inertia_kg_m2 = J;
  loop.settings.torqueConstant_Nm_per_A = Kt;
  loop.settings.gains.velocity_kp_A_s_per_rad = 60.0 * J / Kt;
  loop.settings.observer_cutoff_rad_per_s = 200.0;
  loop.settings.current_limit_A = 5.0;
  loop.delay_ticks = delay_ticks;
  return loop;
}

}  // namespace breakaway::test
