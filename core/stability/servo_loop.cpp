#include "stability/servo_loop.h"

#include <cassert>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

namespace breakaway {

namespace {

/// A signal as a row of coefficients: of all states, then of all inputs.
using Signal = Eigen::RowVectorXd;

enum State {
  windingCurrent,
  rotorSpeed,
  movement,  ///< of the rotor over the last tick
  rotorAngle,
  lastAngleNoise,
  angleError,  ///< of the speed observer, true minus estimated
  estimatedSpeed,
  estimatedAcceleration,
  lastCurrent,
  observerState,
  slope,
  lastSpeed,
  motionIntegral,
  currentIntegral,
  firstDelayed  ///< commands under way, the newest first
};

enum Input { reference, load, angleNoise, currentNoise, injected, inputs };

/// One tick of the controller and the motor, written as in ServoController::step() with signals for numbers.
class Tick {
 public:
  Tick(const ServoLoop& loop, bool cut);

  DiscreteSystem system(const std::vector<Input>& from, const std::vector<Signal>& to) const;
  /// In the order of LoopOutput.
  std::vector<Signal> outputSignals() const;
  Signal returned() const { return -1.0 * state(movement); }

 private:
  Signal state(Eigen::Index which) const { return Signal::Unit(states_ + inputs, which); }
  Signal input(Input which) const { return Signal::Unit(states_ + inputs, states_ + which); }
  Signal nothing() const { return Signal::Zero(states_ + inputs); }
  void next(Eigen::Index which, const Signal& value);

  Signal sensedSpeed(const Signal& current);
  Signal compensation(const Signal& current, const Signal& speed);
  Signal motion(const Signal& speed);
  Signal integrated(const Signal& direct, double growth, const Signal& error);
  Signal winding(const Signal& reference_A, const Signal& current, const Signal& speed);
  Signal delayed(const Signal& command);
  void move(const Signal& drive);

  const ServoLoop& loop_;
  double T_;
  Eigen::Index states_;
  Eigen::MatrixXd next_;
  std::vector<bool> used_;
  Signal measured_;  ///< movement over the last tick as it reaches the controller
  Signal speed_, estimate_, current_, voltage_;
};

Tick::Tick(const ServoLoop& loop, bool cut)
    : loop_(loop), T_(loop.board.tick_s), states_(firstDelayed + loop.delay_ticks) {
  next_ = Eigen::MatrixXd::Zero(states_, states_ + inputs);
  used_.assign(static_cast<size_t>(states_), false);
  measured_ = cut ? input(injected) : state(movement);
  const Signal current = state(windingCurrent) + input(currentNoise);
  speed_ = sensedSpeed(current);
  const Signal compensated = compensation(current, speed_);
  current_ = motion(speed_) + compensated;
  const bool wound = loop.current == CurrentPath::winding;
  voltage_ = wound ? winding(current_, current, speed_) : nothing();
  move(delayed(wound ? voltage_ : current_));
}

void Tick::next(Eigen::Index which, const Signal& value) {
  next_.row(which) = value;
  used_[static_cast<size_t>(which)] = true;
}

Signal Tick::sensedSpeed(const Signal& current) {
  if (loop_.speed == SpeedSource::backwardDifference) {
    next(lastAngleNoise, input(angleNoise));
    return (measured_ + input(angleNoise) - state(lastAngleNoise)) / T_;
  }
  const auto gains = VelocityObserverGains<double>::placed(loop_.board.velocityBandwidth_rad_per_s, T_);
  const ServoSettings<double>& known = loop_.settings;
  const double perAmp = known.inertia_kg_m2 > 0.0 ? known.torqueConstant_Nm_per_A / known.inertia_kg_m2 : 0.0;
  const Signal acceleration = state(estimatedAcceleration) + perAmp * (current - state(lastCurrent));
  const Signal expected = T_ * (state(estimatedSpeed) + 0.5 * T_ * acceleration);
  const Signal off = state(angleError) + measured_ - expected;  // of the angle itself
  const Signal error = off + input(angleNoise);
  Signal speed = state(estimatedSpeed) + T_ * acceleration + gains.velocity_per_s * error;
  next(angleError, off - gains.angle * error);
  next(estimatedSpeed, speed);
  next(estimatedAcceleration, acceleration + gains.acceleration_per_s2 * error);
  next(lastCurrent, current);
  return speed;
}

Signal Tick::compensation(const Signal& current, const Signal& speed) {
  const ServoSettings<double>& s = loop_.settings;
  estimate_ = nothing();
  if (!(s.observer_cutoff_rad_per_s > 0.0) || !(s.torqueConstant_Nm_per_A > 0.0)) return nothing();
  const double pole = exponential<double>(-s.observer_cutoff_rad_per_s * T_);
  const double momentum = s.observer_cutoff_rad_per_s * s.inertia_kg_m2;
  const Signal filtered =
      pole * state(observerState) + (1.0 - pole) * (s.torqueConstant_Nm_per_A * current + momentum * speed);
  next(observerState, filtered);
  estimate_ = filtered - momentum * speed;
  return estimate_ / s.torqueConstant_Nm_per_A;
}

Signal Tick::motion(const Signal& speed) {
  const MotionGains<double>& g = loop_.settings.gains;
  if (loop_.mode == ServoMode::position) {
    const Signal angle = state(rotorAngle) + measured_;
    next(rotorAngle, angle);
    const Signal error = input(reference) - angle - input(angleNoise);
    return integrated(g.position_kp_A_per_rad * error - g.position_kd_A_s_per_rad * speed, g.position_ki_A_per_rad_s,
                      error);
  }
  const Signal error = input(reference) - speed;
  Signal direct = g.velocity_kp_A_s_per_rad * error;
  if (g.velocity_kd_A_s2_per_rad > 0.0) {
    const Signal change = (speed - state(lastSpeed)) / T_;
    const Signal smoothed = state(slope) + MotionController<double>::slopeShare * (change - state(slope));
    next(slope, smoothed);
    next(lastSpeed, speed);
    direct -= g.velocity_kd_A_s2_per_rad * smoothed;
  }
  return integrated(direct, g.velocity_ki_A_per_rad, error);
}

Signal Tick::integrated(const Signal& direct, double growth, const Signal& error) {
  if (!(growth > 0.0)) return direct;
  next(motionIntegral, state(motionIntegral) + growth * T_ * error);
  return direct + state(motionIntegral);
}

Signal Tick::winding(const Signal& reference_A, const Signal& current, const Signal& speed) {
  const auto& c = loop_.board.current;
  const Signal error = reference_A - current;
  next(currentIntegral, state(currentIntegral) + c.resistance_ohm * c.bandwidth_rad_per_s * T_ * error);
  return c.resistance_ohm * reference_A + c.backEmfConstant_V_s_per_rad * speed +
         c.inductance_H * c.bandwidth_rad_per_s * error + state(currentIntegral);
}

Signal Tick::delayed(const Signal& command) {
  Signal acting = command;
  for (int k = 0; k < loop_.delay_ticks; ++k) {
    next(firstDelayed + k, acting);
    acting = state(firstDelayed + k);
  }
  return acting;
}

/// States current, speed and movement within the tick; held inputs drive and load.
void Tick::move(const Signal& drive) {
  const LoopMotor& m = loop_.motor;
  const double J = m.inertia_kg_m2;
  const bool wound = loop_.current == CurrentPath::winding;
  Eigen::Matrix<double, 5, 5> F = Eigen::Matrix<double, 5, 5>::Zero();
  if (wound) {
    F.row(0) << -m.resistance_ohm / m.inductance_H, -m.backEmfConstant_V_s_per_rad / m.inductance_H, 0.0,
        1.0 / m.inductance_H, 0.0;
    F.row(1) << m.torqueConstant_Nm_per_A / J, -m.viscous_Nm_s_per_rad / J, 0.0, 0.0, -1.0 / J;
  } else {
    F.row(1) << 0.0, -m.viscous_Nm_s_per_rad / J, 0.0, m.torqueConstant_Nm_per_A / J, -1.0 / J;
  }
  F(2, 1) = 1.0;
  const Eigen::Matrix<double, 5, 5> over = (F * T_).eval().exp();
  const auto after = [&](Eigen::Index row) {
    const double ofCurrent = wound ? over(row, 0) : 0.0;
    return Signal(ofCurrent * state(windingCurrent) + over(row, 1) * state(rotorSpeed) + over(row, 3) * drive +
                  over(row, 4) * input(load));
  };
  next(windingCurrent, wound ? after(0) : drive);
  next(rotorSpeed, after(1));
  next(movement, after(2));
}

std::vector<Signal> Tick::outputSignals() const {
  const bool positioned = loop_.mode == ServoMode::position;
  const Signal angle = positioned ? Signal(state(rotorAngle) + state(movement)) : nothing();
  return {state(rotorSpeed), speed_, estimate_, current_, voltage_, angle};
}

DiscreteSystem Tick::system(const std::vector<Input>& from, const std::vector<Signal>& to) const {
  std::vector<Eigen::Index> kept, driven;
  for (Eigen::Index k = 0; k < states_; ++k) {
    if (used_[static_cast<size_t>(k)]) kept.push_back(k);
  }
  for (const Input one : from) driven.push_back(states_ + one);
  Eigen::MatrixXd out(static_cast<Eigen::Index>(to.size()), states_ + inputs);
  for (size_t k = 0; k < to.size(); ++k) out.row(static_cast<Eigen::Index>(k)) = to[k];
  return {next_(kept, kept), next_(kept, driven), out(Eigen::all, kept), out(Eigen::all, driven), T_};
}

struct Needed {
  const char* field;
  double value;
};

}  // namespace

double ServoLoop::alpha() const {
  return settings.inertia_kg_m2 * motor.torqueConstant_Nm_per_A /
         (motor.inertia_kg_m2 * settings.torqueConstant_Nm_per_A);
}

double ServoLoop::alphaGT() const {
  return alpha() * settings.observer_cutoff_rad_per_s * board.tick_s;
}

Result<void> check(const ServoLoop& loop) {
  const bool wound = loop.current == CurrentPath::winding, observed = loop.speed == SpeedSource::observer;
  const auto positive = [](const std::vector<Needed>& all) -> Result<void> {
    for (const Needed& one : all) {
      if (!(one.value > 0.0) || !std::isfinite(one.value)) return Error{one.field, message("must be positive")};
    }
    return {};
  };
  if (auto fine = positive({{"tick_s", loop.board.tick_s},
                            {"inertia_kg_m2", loop.motor.inertia_kg_m2},
                            {"torque_constant_Nm_per_A", loop.motor.torqueConstant_Nm_per_A},
                            {"nominal_inertia_kg_m2", loop.settings.inertia_kg_m2},
                            {"nominal_torque_constant_Nm_per_A", loop.settings.torqueConstant_Nm_per_A}});
      !fine)
    return fine;
  if (wound) {
    if (auto fine =
            positive({{"resistance_ohm", loop.motor.resistance_ohm}, {"inductance_H", loop.motor.inductance_H}});
        !fine)
      return fine;
  }
  if (observed && !(loop.board.velocityBandwidth_rad_per_s > 0.0))
    return Error{"velocity_bandwidth_rad_per_s", message("must be positive")};
  if (loop.delay_ticks < 0 || loop.delay_ticks > 20) return Error{"delay_ticks", message("must be from 0 to 20")};
  if (loop.mode != ServoMode::velocity && loop.mode != ServoMode::position)
    return Error{"mode", message("must be velocity or position")};
  return {};
}

DiscreteSystem closedLoop(const ServoLoop& loop) {
  assert(check(loop));
  const Tick tick(loop, false);
  return tick.system({reference, load, angleNoise, currentNoise}, tick.outputSignals());
}

DiscreteSystem openLoop(const ServoLoop& loop) {
  assert(check(loop));
  const Tick tick(loop, true);
  return tick.system({injected}, {tick.returned()});
}

}  // namespace breakaway
