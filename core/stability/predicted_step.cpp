#include "stability/predicted_step.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace breakaway {

namespace {

constexpr double substepsPerTimeConstant = 8.0;
constexpr double leastSubsteps = 4.0, mostSubsteps = 200.0;
constexpr double unlimited_V = 1e6;

/// The motor between two ticks.
class Shaft {
 public:
  Shaft(const ServoLoop& loop, const StepWanted& wanted)
      : motor_(loop.motor), coulomb_Nm_(wanted.coulomb_Nm), static_Nm_(std::max(wanted.static_Nm, wanted.coulomb_Nm)) {
    const double tick_s = loop.board.tick_s;
    double substeps = leastSubsteps;
    if (loop.current == CurrentPath::winding)
      substeps = substepsPerTimeConstant * tick_s * motor_.resistance_ohm / motor_.inductance_H;
    count_ = static_cast<int>(std::ceil(std::clamp(substeps, leastSubsteps, mostSubsteps)));
    step_s_ = tick_s / count_;
  }

  void underVoltage(double voltage_V) {
    for (int k = 0; k < count_; ++k) {
      const double slope =
          (voltage_V - motor_.resistance_ohm * current_A - motor_.backEmfConstant_V_s_per_rad * speed) /
          motor_.inductance_H;
      // Backward in the current, which is the fast one.
      current_A += step_s_ * slope / (1.0 + step_s_ * motor_.resistance_ohm / motor_.inductance_H);
      move();
    }
  }

  void underCurrent(double held_A) {
    current_A = held_A;
    for (int k = 0; k < count_; ++k) move();
  }

  double angle = 0.0, speed = 0.0, current_A = 0.0;

 private:
  void move() {
    const double drive_Nm = motor_.torqueConstant_Nm_per_A * current_A - motor_.viscous_Nm_s_per_rad * speed;
    const double per_s = step_s_ / motor_.inertia_kg_m2;
    if (speed == 0.0 && std::abs(drive_Nm) <= static_Nm_) return;
    const double way = speed != 0.0 ? std::copysign(1.0, speed) : std::copysign(1.0, drive_Nm);
    double next = speed + per_s * (drive_Nm - way * coulomb_Nm_);
    if (speed != 0.0 && next * speed < 0.0) next = 0.0;  // friction stops it, and doesn't turn it round
    angle += 0.5 * step_s_ * (speed + next);
    speed = next;
  }

  LoopMotor motor_;
  double coulomb_Nm_, static_Nm_, step_s_ = 0.0;
  int count_ = 1;
};

double counted(double angle_rad, double count_rad) {
  return count_rad > 0.0 ? count_rad * std::floor(angle_rad / count_rad) : angle_rad;
}

}  // namespace

PredictedStep predictStep(const ServoLoop& loop, const StepWanted& wanted) {
  const double tick_s = loop.board.tick_s;
  ServoController<double> controller(loop.board);
  controller.configure(loop.settings);
  Shaft shaft(loop, wanted);
  const bool position = loop.mode == ServoMode::position;
  const double from = position ? 0.0 : wanted.from_rad_per_s, to = position ? wanted.to_rad : wanted.to_rad_per_s;
  shaft.speed = position ? 0.0 : wanted.from_rad_per_s;
  const double supply_V = wanted.supply_V > 0.0 ? wanted.supply_V : unlimited_V;
  std::deque<ServoOutput<double>> underWay(static_cast<size_t>(std::max(0, loop.delay_ticks)));
  PredictedStep step;
  const auto before = static_cast<long>(std::lround(wanted.before_s / tick_s));
  const auto after = static_cast<long>(std::lround(wanted.after_s / tick_s));
  for (long tick = -before; tick <= after; ++tick) {
    controller.command({loop.mode, tick >= 0 ? to : from, 0.0, false});
    underWay.push_back(controller.step(counted(shaft.angle, loop.board.count_rad), shaft.current_A, supply_V));
    step.time_s.push_back(static_cast<double>(tick) * tick_s);
    step.velocity_rad_per_s.push_back(shaft.speed);
    step.current_A.push_back(shaft.current_A);
    step.angle_rad.push_back(shaft.angle);
    const ServoOutput<double> acting = underWay.front();
    underWay.pop_front();
    loop.current == CurrentPath::winding ? shaft.underVoltage(acting.voltage_V)
                                         : shaft.underCurrent(acting.current_reference_A);
  }
  return step;
}

}  // namespace breakaway
