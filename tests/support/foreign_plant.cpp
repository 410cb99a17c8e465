#include "support/foreign_plant.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace breakaway::test {

namespace {

constexpr double mostStep_s = 1e-5;
constexpr double pitch_m = 0.02;  // of a linear axis' screw: its waves are counted by it

double sumOf(const std::vector<Wave>& waves, double angle) {
  double sum = 0.0;
  for (const Wave& wave : waves) sum += wave.amplitude * std::cos(wave.order * angle - wave.phase);
  return sum;
}

double signed1(double value) {
  return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0;
}

/// One recording: the plant in small steps beneath the loop's ticks, each of them a row.
class Plant {
 public:
  Plant(const Motor& motor, const Driven& driven, const Concealed& hidden, const Sensors& sensors, double rate_Hz,
        Draw& draw)
      : m_(motor), driven_(driven), c_(hidden), s_(sensors), draw_(draw), tick_s_(1.0 / rate_Hz) {}

  Rows run(const Moves& moves, double length_s) {
    Rows rows;
    wanders_ = s_.wander * draw_.normal();
    const auto parts = static_cast<size_t>(std::ceil(tick_s_ / mostStep_s));
    const auto ticks = static_cast<size_t>(length_s / tick_s_);
    const double between_s = tick_s_ / static_cast<double>(parts);
    for (size_t k = 0; k < ticks; ++k) {
      const double now_s = static_cast<double>(k) * tick_s_, shown = shownAngle();
      asked_.push_back(asked(moves, now_s, shown));
      rows.time.push_back(now_s);
      rows.shown.push_back(shown);
      rows.drive.push_back(asked_.back());
      rows.current.push_back(read(amperes_));
      rows.lowest = std::min(rows.lowest, angle_);
      rows.highest = std::max(rows.highest, angle_);
      for (size_t part = 0; part < parts; ++part) go(now_s + static_cast<double>(part) * between_s, between_s);
    }
    return rows;
  }

 private:
  double ofTurn(double angle) const { return m_.linear ? turn / pitch_m * angle : angle; }

  double shownAngle() const {
    const double disc = m_.linear ? 0.0 : c_.discOff * std::sin(angle_ - c_.discAt);
    const double line = s_.lineError * std::sin(2.0 * ofTurn(angle_) + 0.7);
    return m_.count() * std::floor((angle_ + disc + line) / m_.count());
  }

  double read(double amperes) { return s_.step_A * std::round((amperes + s_.noise_A * draw_.normal()) / s_.step_A); }

  /// In V, A or Nm as the drive has it, before a delay.
  double asked(const Moves& moves, double now_s, double shown) {
    if (moves.drive) return moves.drive(now_s);
    const double speed = now_s > 0.0 ? (shown - before_) / tick_s_ : 0.0;
    before_ = shown;
    speed_ += std::min(1.0, turn * std::min(60.0, 1.0 / tick_s_ / 12.0) * tick_s_) * (speed - speed_);
    const double wanted = moves.reference(now_s), error = moves.place ? wanted - shown : wanted - speed_;
    double out = moves.kp * error + moves.ki * sum_;
    if (moves.place) out += moves.kd * ((moves.reference(now_s + 1e-4) - wanted) / 1e-4 - speed_);
    const double most = driven_.volts() ? 0.9 * m_.supply_V : m_.most_A;
    if (std::abs(out) < most) sum_ += error * tick_s_;
    return std::clamp(out, -most, most);
  }

  void drive(double now_s, double dt) {
    const double at = (now_s - c_.late_s) / tick_s_;
    const double acts = at < -1e-9 ? 0.0 : asked_[std::min(static_cast<size_t>(at + 1e-9), asked_.size() - 1)];
    if (!driven_.volts()) {
      amperes_ += (acts - amperes_) * -std::expm1(-5000.0 * dt);
      return;
    }
    const double share = std::abs(acts) / m_.supply_V;
    const double sag = acts * amperes_ > 0.0 ? share * share * c_.source_ohm * std::abs(amperes_) : 0.0;
    const double ohm = m_.resistance * (1.0 + c_.warming * heat_);
    const double lost = sag * signed1(acts) + c_.deadVolts * std::tanh(amperes_ / (0.02 * m_.most_A));
    const double settles_A = (acts - lost - m_.constant * velocity_) / ohm;
    amperes_ += (settles_A - amperes_) * -std::expm1(-ohm / m_.inductance * dt);
    const double part = amperes_ / m_.most_A;
    heat_ += dt / c_.warming_s * (6.0 * part * part - heat_);
  }

  double motorTorque() const {
    const double part = amperes_ / m_.most_A;
    double torque = m_.constant * amperes_ / (1.0 + c_.saturation * part * part);
    if (c_.deadTorque > 0.0)
      torque = std::abs(torque) < c_.deadTorque ? 0.0 : torque - std::copysign(c_.deadTorque, torque);
    return std::clamp(torque, -c_.clutch, c_.clutch);
  }

  /// What pushes beside the motor, whatever the friction.
  double pushes(double now_s) const {
    double torque = -c_.load - s_.pull - c_.arm * std::sin(angle_ - c_.armDown);
    torque -= sumOf(c_.detents, ofTurn(angle_)) + sumOf(s_.trifles, ofTurn(angle_));
    for (const Push& one : c_.pushes)
      if (now_s >= one.from_s && now_s < one.until_s) torque -= one.torque;
    if (angle_ > c_.high) torque -= std::max(0.0, c_.stopStiffness * (angle_ - c_.high) + c_.stopDamping * velocity_);
    if (c_.catching > 0.0) {
      const double off = std::remainder(angle_ - c_.catchAt, turn) / c_.catchWidth;
      torque -= c_.catching * off * std::exp(0.5 - 0.5 * off * off);
    }
    return torque;
  }

  double friction(double now_s, double torque, double dt) {
    const double speed = std::abs(velocity_);
    double sum = m_.coulomb * (1.0 + wanders_) + sumOf(c_.uneven, ofTurn(angle_)) + c_.ofTorque * std::abs(torque);
    sum += c_.stribeck * std::exp(-std::pow(speed / c_.stribeckSpeed, 2)) + c_.drag * speed * speed;
    if (c_.breathing > 0.0) sum *= 1.0 + c_.breathing * std::sin(turn * now_s / c_.breathing_s);
    if (c_.above > 0.0) {
      fast_ = speed > c_.aboveSpeed || (fast_ && speed > 0.6 * c_.aboveSpeed);
      sum += fast_ ? c_.above : 0.0;
    }
    if (c_.thinning > 0.0) {
      thick_ += dt * ((1.0 - thick_) / c_.thinning_s - thick_ * speed / c_.thinningSpeed);
      sum += c_.thinning * thick_;
    }
    return std::max(sum, 0.05 * m_.coulomb);
  }

  static double slowed(double velocity, double by) {
    return std::abs(velocity) <= by ? 0.0 : velocity - std::copysign(by, velocity);
  }

  /// Torque that goes to the load behind the motor.
  double transmitted() const {
    const double twist = angle_ - loadAngle_, rate = velocity_ - loadVelocity_, half = 0.5 * c_.play;
    if (c_.play > 0.0 && std::abs(twist) <= half) return 0.0;
    const double torque = c_.stiffness * (twist - std::copysign(half, twist)) + c_.damping * rate;
    return c_.play > 0.0 && torque * twist < 0.0 ? 0.0 : torque;  // teeth don't pull
  }

  void go(double now_s, double dt) {
    drive(now_s, dt);
    wanders_ += s_.wander * std::sqrt(2.0 * dt / s_.wander_s) * draw_.normal() - wanders_ * dt / s_.wander_s;
    const double torque = motorTorque();
    double acts = torque + pushes(now_s) - m_.viscous * velocity_;
    double holds = friction(now_s, torque, dt);
    if (c_.loadInertia > 0.0) {
      const double goes = transmitted();
      acts -= goes;
      const double next =
          slowed(loadVelocity_ + dt * goes / c_.loadInertia, c_.loadFriction * m_.coulomb * dt / c_.loadInertia);
      loadAngle_ += 0.5 * dt * (loadVelocity_ + next);
      loadVelocity_ = next;
      holds *= 1.0 - c_.loadFriction;
    }
    if (c_.bristle > 0.0) {
      const double slip = slip_;
      slip_ =
          std::clamp(slip + dt * velocity_ * (1.0 - signed1(velocity_) * slip) * c_.bristle / m_.coulomb, -1.0, 1.0);
      acts -= holds * slip + 0.6 * std::sqrt(c_.bristle * m_.inertia) * velocity_ * (1.0 - std::abs(slip));
      holds = 0.0;
    }
    const double next = slowed(velocity_ + dt * acts / m_.inertia, dt * holds / m_.inertia);
    angle_ += 0.5 * dt * (velocity_ + next);
    velocity_ = next;
  }

  const Motor& m_;
  const Driven& driven_;
  const Concealed& c_;
  const Sensors& s_;
  Draw& draw_;
  double tick_s_;
  std::vector<double> asked_;
  double angle_ = 0.0, velocity_ = 0.0, amperes_ = 0.0, heat_ = 0.0, wanders_ = 0.0, slip_ = 0.0, thick_ = 1.0;
  double loadAngle_ = 0.0, loadVelocity_ = 0.0, before_ = 0.0, speed_ = 0.0, sum_ = 0.0;
  bool fast_ = false;
};

}  // namespace

Rows rowsOf(const Motor& motor, const Driven& driven, const Concealed& hidden, const Sensors& sensors,
            const Moves& moves, double length_s, double rate_Hz, Draw& draw) {
  return Plant(motor, driven, hidden, sensors, rate_Hz, draw).run(moves, length_s);
}

}  // namespace breakaway::test
