#include "support/foreign_rig.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <utility>

namespace breakaway::test {

namespace {

constexpr double turn = 6.283185307179586, mostStep_s = 1e-5;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double pitch_m = 0.02;  // of a linear axis' screw: its waves are counted by it

class Draw {
 public:
  Draw(const std::string& family, std::uint64_t seed) {
    std::uint64_t mixed = seed * 7919 + 17;
    for (const char one : family) mixed = mixed * 131 + static_cast<unsigned char>(one);
    bits_.seed(mixed);
  }
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits_); }
  double evenly(double low, double high) { return low * std::exp(between(0.0, std::log(high / low))); }  ///< by ratio
  double normal() { return std::normal_distribution<double>()(bits_); }
  bool chance(double part) { return between(0.0, 1.0) < part; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(bits_); }
  template <typename T, size_t n>
  T oneOf(const std::array<T, n>& all) {
    return all[static_cast<size_t>(whole(0, static_cast<int>(n) - 1))];
  }

 private:
  std::mt19937_64 bits_;
};

/// In N, m and kg where it is linear.
struct Motor {
  const char* make;
  bool linear;
  double constant, resistance, inductance, inertia, coulomb, supply_V, counts;
  double viscous = 0.0, most_A = 0.0, fastest = 0.0;

  double peak() const { return constant * most_A; }
  double count() const { return linear ? 1.0 / counts : turn / counts; }
};

constexpr std::array<Motor, 6> makes{{{"gimbal motor", false, 0.06, 6.0, 2e-3, 2.5e-5, 1.5e-3, 12.0, 8192.0},
                                      {"hobby servo", false, 1.0, 3.0, 5e-4, 5e-3, 0.1, 7.4, 4096.0},
                                      {"brushless motor", false, 0.06, 0.5, 5e-4, 2e-5, 0.02, 24.0, 4000.0},
                                      {"NEMA 23", false, 0.35, 1.2, 3e-3, 5e-5, 0.04, 36.0, 4000.0},
                                      {"400 W servo", false, 0.5, 1.6, 6e-3, 1.5e-4, 0.06, 160.0, 65536.0},
                                      {"belt axis", true, 60.0, 2.0, 4e-3, 12.0, 25.0, 100.0, 2e5}}};

Motor motorFrom(Draw& draw, bool rotary) {
  Motor m = makes[static_cast<size_t>(draw.whole(0, rotary ? 4 : 5))];
  for (double* value : {&m.constant, &m.resistance, &m.inductance, &m.inertia, &m.coulomb})
    *value *= draw.evenly(0.6, 1.7);
  m.counts *= draw.oneOf(std::array{0.5, 1.0, 2.0});
  m.most_A = std::min(0.8 * m.supply_V / m.resistance, draw.evenly(6.0, 20.0) * m.coulomb / m.constant);
  m.fastest = std::min(0.8 * m.supply_V / m.constant, m.linear ? 0.8 : 250.0);
  m.viscous = m.coulomb / m.fastest * draw.evenly(0.2, 1.5);
  return m;
}

/// `measured`: a current that is read, not asked for.
struct Driven {
  DriveInput input;
  bool measured;
  bool beside;  ///< the current is read beside the voltage
  const char* words;

  bool volts() const { return input == DriveInput::voltage || input == DriveInput::duty; }
};
constexpr std::array<Driven, 6> drives{{{DriveInput::voltage, false, false, "voltage"},
                                        {DriveInput::voltage, false, true, "voltage, current read"},
                                        {DriveInput::duty, false, false, "duty"},
                                        {DriveInput::current, false, false, "current asked for"},
                                        {DriveInput::current, true, false, "current read"},
                                        {DriveInput::torque, false, false, "torque"}}};

struct Wave {
  double amplitude;
  int order;
  double phase;
};
struct Push {
  double from_s, until_s, torque;
};

/// What the bench doesn't tell; zero where it isn't there.
struct Concealed {
  double loadInertia = 0.0, play = 0.0, stiffness = 0.0, damping = 0.0, loadFriction = 0.0;  ///< behind the motor
  double stopStiffness = 0.0, stopDamping = 0.0, high = never;
  double late_s = 0.0;
  double stribeck = 0.0, stribeckSpeed = 1.0;
  double bristle = 0.0;  ///< stiffness of elastic friction
  double load = 0.0, arm = 0.0, armDown = 0.0;
  std::vector<Wave> detents, uneven;
  double ofTorque = 0.0;  ///< friction by what is transmitted
  double deadVolts = 0.0, source_ohm = 0.0;
  double warming = 0.0, warming_s = 10.0;
  double drag = 0.0, saturation = 0.0;
  double discOff = 0.0, discAt = 0.0;
  std::vector<Push> pushes;
  // What the catalogue lacks.
  double deadTorque = 0.0, clutch = never;
  double breathing = 0.0, breathing_s = 1.0;
  double catching = 0.0, catchWidth = 1.0, catchAt = 0.0;
  double above = 0.0, aboveSpeed = 1.0;
  double thinning = 0.0, thinning_s = 1.0, thinningSpeed = 1.0;
};

struct Sensors {
  double lineError = 0.0, wander = 0.0, wander_s = 1.0;
  double noise_A = 0.0, step_A = 0.0, missing = 0.0;
  double pull = 0.0;  ///< a steady torque too small to matter
  std::vector<Wave> trifles;
};

/// What is asked for: a drive by itself, or a speed or place that a loop follows.
struct Moves {
  const char* words = "";
  std::function<double(double)> drive, reference;
  bool place = false;
  double kp = 0.0, ki = 0.0, kd = 0.0;
};

double sumOf(const std::vector<Wave>& waves, double angle) {
  double sum = 0.0;
  for (const Wave& wave : waves) sum += wave.amplitude * std::cos(wave.order * angle - wave.phase);
  return sum;
}

double signed1(double value) {
  return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0;
}

struct Rows {
  std::vector<double> time, shown, drive, current;
  double lowest = never, highest = -never;
};

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

/// What a family's rigs must be, beside what they conceal.
struct Family {
  ForeignFamily known;
  bool rotary = false, volts = false, travels = false, quick = false;
  /// Makes it, with its size in words; `length_s` of the recording, `rate_Hz` of its rows.
  std::function<std::string(Concealed&, const Motor&, Draw&, double length_s, double rate_Hz)> conceal;
};

std::string part(double of, double whole) {
  return fmt::format("{:.0f} % of the friction", 100.0 * of / whole);
}

using C = Concealed;
using M = Motor;
using D = Draw;

/// Two masses that swing against each other at so many Hz.
void twoMasses(C& c, const M& m, D& draw, double Hz, double damping) {
  c.loadInertia = draw.evenly(0.4, 3.0) * m.inertia;
  const double reduced = m.inertia * c.loadInertia / (m.inertia + c.loadInertia), swing = turn * Hz;
  c.stiffness = swing * swing * reduced;
  c.damping = 2.0 * damping * swing * reduced;
  c.loadFriction = draw.chance(0.5) ? draw.between(0.02, 0.3) : 0.0;
}

std::vector<Family> catalogued() {
  constexpr auto an = Conceals::anEffect;
  std::vector<Family> all;
  all.push_back({{"backlash", an}, false, false, false, true, [](C& c, const M& m, D& d, double, double) {
                   twoMasses(c, m, d, d.evenly(30.0, 125.0), d.evenly(0.1, 0.5));
                   c.play = std::max(m.linear ? d.evenly(5e-5, 1e-3) : d.evenly(8e-3, 0.08), 12.0 * m.count());
                   return fmt::format("play of {:.2g}, load {:.1f} J", c.play, c.loadInertia / m.inertia);
                 }});
  all.push_back({{"compliance", an}, false, false, false, true, [](C& c, const M& m, D& d, double, double rate_Hz) {
                   const double Hz = d.evenly(15.0, std::min(150.0, rate_Hz / 6.0));
                   twoMasses(c, m, d, Hz, d.evenly(0.01, 0.1));
                   return fmt::format("swings at {:.0f} Hz, load {:.1f} J", Hz, c.loadInertia / m.inertia);
                 }});
  all.push_back({{"end_stop", an}, false, false, true, false, [](C& c, const M& m, D& d, double, double) {
                   const double swing = turn * d.evenly(5.0, 80.0);
                   c.stopStiffness = swing * swing * m.inertia;
                   c.stopDamping = 2.0 * d.evenly(0.03, 0.5) * swing * m.inertia;
                   return fmt::format("a stop of {:.0f} Hz", swing / turn);
                 }});
  all.push_back({{"transport_delay", an}, false, false, false, true, [](C& c, const M&, D& d, double, double rate_Hz) {
                   c.late_s = std::clamp(d.evenly(1.5, 8.0) / rate_Hz, 1.5e-3, 0.02);
                   return fmt::format("{:.1f} ms late", 1e3 * c.late_s);
                 }});
  all.push_back({{"stribeck", an}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.stribeck = d.between(0.2, 0.5) * m.coulomb;
                   c.stribeckSpeed = d.evenly(0.01, 0.06) * m.fastest;
                   return part(c.stribeck, m.coulomb);
                 }});
  all.push_back({{"presliding", an}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   const double over = d.evenly(6.0, 60.0);
                   c.bristle = m.coulomb / (over * m.count());
                   return fmt::format("over {:.0f} counts", over);
                 }});
  all.push_back({{"constant_load", an}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.load = d.sign() * d.between(0.08, 0.5) * m.coulomb;
                   return part(c.load, m.coulomb);
                 }});
  all.push_back({{"imbalance", an}, true, false, true, false, [](C& c, const M& m, D& d, double, double) {
                   c.arm = d.between(0.12, 0.6) * m.coulomb;
                   c.armDown = d.between(-3.0, 3.0);
                   return part(c.arm, m.coulomb);
                 }});
  const auto waves = [](const M& m, D& d, int most, auto orderOf) {
    std::vector<Wave> some;
    const int count = d.whole(1, most);
    some.reserve(static_cast<size_t>(count));
    for (int k = 0; k < count; ++k)
      some.push_back({d.between(0.12, 0.4) * m.coulomb / (k + 1), orderOf(), d.between(0.0, turn)});
    return some;
  };
  const auto orders = [](const std::vector<Wave>& some, double coulomb) {
    std::string words = "orders";
    for (const Wave& wave : some) words += fmt::format(" {} ({:.0f} %)", wave.order, 100.0 * wave.amplitude / coulomb);
    return words;
  };
  all.push_back({{"cogging", an}, false, false, true, false, [=](C& c, const M& m, D& d, double, double) {
                   c.detents = waves(m, d, 3, [&] {
                     return m.linear ? d.whole(1, 2) : d.oneOf(std::array{4, 6, 7, 8, 12, 14, 21, 24, 42});
                   });
                   return orders(c.detents, m.coulomb);
                 }});
  all.push_back(
      {{"position_dependent_friction", an}, false, false, true, false, [=](C& c, const M& m, D& d, double, double) {
         c.uneven = waves(m, d, 2, [&] { return m.linear ? 1 : d.whole(1, 6); });
         return orders(c.uneven, m.coulomb);
       }});
  all.push_back({{"load_dependent_friction", an}, false, false, false, false, [](C& c, const M&, D& d, double, double) {
                   c.ofTorque = d.between(0.1, 0.3);
                   return fmt::format("{:.0f} % of the torque", 100.0 * c.ofTorque);
                 }});
  all.push_back({{"dead_time", an}, false, true, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.deadVolts = d.between(0.01, 0.05) * m.supply_V;
                   return fmt::format("{:.2g} V", c.deadVolts);
                 }});
  all.push_back({{"winding_heating", an}, false, true, false, false, [](C& c, const M&, D& d, double, double) {
                   c.warming = d.between(0.12, 0.4);
                   c.warming_s = d.evenly(5.0, 30.0);
                   return fmt::format("{:.0f} %, within {:.0f} s", 100.0 * c.warming, c.warming_s);
                 }});
  all.push_back({{"quadratic_drag", an}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.drag = d.between(0.3, 1.2) * m.coulomb / std::pow(0.5 * m.fastest, 2);
                   return fmt::format("{:.0f} % of the friction at half speed",
                                      25.0 * c.drag * m.fastest * m.fastest / m.coulomb);
                 }});
  all.push_back({{"torque_saturation", an}, false, false, false, false, [](C& c, const M&, D& d, double, double) {
                   c.saturation = d.between(0.15, 0.5);
                   return fmt::format("1/{:.2f} at the peak", 1.0 + c.saturation);
                 }});
  all.push_back({{"supply_sag", an}, false, true, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.source_ohm = d.between(0.06, 0.25) * m.supply_V / m.most_A;
                   return fmt::format("{:.2g} ohm", c.source_ohm);
                 }});
  all.push_back({{"encoder_eccentricity", an}, true, false, true, false, [](C& c, const M& m, D& d, double, double) {
                   c.discOff = std::max(d.evenly(4e-3, 4e-2), 6.0 * m.count());
                   c.discAt = d.between(-3.0, 3.0);
                   return fmt::format("{:.2g} rad", c.discOff);
                 }});
  all.push_back(
      {{"external_disturbance", an}, false, false, false, false, [](C& c, const M& m, D& d, double length_s, double) {
         const double from_s = d.between(0.1, 0.7) * length_s;
         c.pushes = {{from_s, from_s + d.evenly(0.1, 1.0), d.sign() * d.between(0.5, 2.5) * m.coulomb}};
         return part(c.pushes[0].torque, m.coulomb);
       }});
  return all;
}

std::vector<Family> beyondCatalogue() {
  constexpr auto outside = Conceals::physicsOutside;
  std::vector<Family> all;
  all.push_back({{"torque_dead_band", outside}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.deadTorque = d.between(0.3, 0.9) * m.coulomb;
                   return part(c.deadTorque, m.coulomb);
                 }});
  all.push_back({{"breathing_friction", outside}, false, false, false, false, [](C& c, const M&, D& d, double, double) {
                   c.breathing = d.between(0.2, 0.5);
                   c.breathing_s = d.between(1.5, 8.0);
                   return fmt::format("{:.0f} % of the friction", 100.0 * c.breathing);
                 }});
  all.push_back({{"slipping_clutch", outside}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.clutch = d.between(0.3, 0.6) * m.peak();
                   return fmt::format("{:.0f} % of the peak", 100.0 * c.clutch / m.peak());
                 }});
  all.push_back({{"magnetic_catch", outside}, true, false, true, false, [](C& c, const M& m, D& d, double, double) {
                   c.catching = d.between(0.6, 1.5) * m.coulomb;
                   c.catchWidth = d.between(0.04, 0.12);
                   c.catchAt = d.between(-2.0, 2.0);
                   return part(c.catching, m.coulomb);
                 }});
  all.push_back(
      {{"friction_of_two_speeds", outside}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
         c.above = d.between(0.4, 0.8) * m.coulomb;
         c.aboveSpeed = d.between(0.15, 0.3) * m.fastest;
         return part(c.above, m.coulomb);
       }});
  all.push_back({{"thixotropy", outside}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.thinning = d.between(0.4, 0.9) * m.coulomb;
                   c.thinning_s = d.evenly(0.5, 4.0);
                   c.thinningSpeed = 0.5 * m.fastest * d.evenly(0.3, 2.0);
                   return part(c.thinning, m.coulomb);
                 }});
  return all;
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> some{{{"sound", Conceals::nothing}, false, false, false, false, {}}};
    for (auto&& more : {catalogued(), beyondCatalogue()}) some.insert(some.end(), more.begin(), more.end());
    return some;
  }();
  return all;
}

Sensors sensorsFrom(Draw& draw, const Motor& m) {
  Sensors s;
  s.lineError = !m.linear && draw.chance(0.5) ? draw.evenly(0.1, 0.6) * m.count() : 0.0;
  s.wander = draw.chance(0.8) ? draw.evenly(0.005, 0.04) : 0.0;
  s.wander_s = draw.evenly(0.005, 8.0);
  s.noise_A = draw.evenly(0.001, 0.015) * m.most_A;
  s.step_A = 3.0 * m.most_A / std::pow(2.0, draw.whole(10, 14));
  s.missing = draw.chance(0.3) ? draw.evenly(5e-4, 0.01) : 0.0;
  s.pull = draw.chance(0.5) ? draw.between(-0.006, 0.006) * m.coulomb : 0.0;
  const int trifles = draw.whole(0, 3);
  for (int k = 0; k < trifles; ++k)
    s.trifles.push_back({draw.evenly(0.001, 0.006) * m.coulomb, draw.whole(1, 24), draw.between(0.0, turn)});
  return s;
}

enum class Kind { steps, chirp, sines, speeds, slowTurns, places };

/// What a loop needs that is to be about so quick.
void closeLoop(Moves& moves, const Motor& m, const Concealed& c, bool volts, double rate_Hz, Draw& draw) {
  const double inertia = m.inertia + c.loadInertia;
  double quick = turn * std::min(draw.evenly(4.0, 15.0), rate_Hz / 40.0);
  if (c.late_s > 0.0) quick = std::min(quick, 0.35 / c.late_s);
  if (c.loadInertia > 0.0) quick = std::min(quick, 0.15 * std::sqrt(c.stiffness / c.loadInertia));
  const double gain = volts ? m.constant / m.resistance : m.constant;
  if (!moves.place) {
    moves.kp = inertia * quick / gain;
    moves.ki = 0.5 * quick * moves.kp;
    return;
  }
  const double braked = volts ? m.constant * m.constant / m.resistance : 0.0;
  moves.kp = inertia * quick * quick / gain;
  moves.kd = std::max(0.0, (1.6 * quick * inertia - braked) / gain);
  moves.ki = draw.chance(0.6) ? 0.2 * quick * moves.kp : 0.0;
}

Moves openMoves(Kind kind, const Motor& m, double inertia, bool volts, double length_s, double rate_Hz, Draw& draw) {
  Moves moves;
  const double moving = m.coulomb / m.constant * (volts ? m.resistance : 1.0);
  const double most = volts ? 0.9 * m.supply_V : std::min(m.most_A, 5.0 * moving);
  const double amplitude = std::min(most, 1.3 * moving + draw.evenly(0.15, 0.7) * std::max(0.0, most - 1.3 * moving));
  if (kind == Kind::steps) {
    moves.words = "steps";
    const double settles_s = inertia * m.fastest / (amplitude * (volts ? m.constant / m.resistance : m.constant));
    const double hold_s = volts ? std::clamp(draw.evenly(0.08, 0.5), 10.0 / rate_Hz, 0.6)
                                : std::clamp(0.6 * settles_s, 5.0 / rate_Hz, 0.4);
    std::vector<double> levels;
    for (double t = 0.0; t < length_s + hold_s; t += hold_s) {
      const bool back = levels.size() % 2 == 1;
      levels.push_back(back ? -levels.back() : draw.sign() * amplitude * draw.between(volts ? 0.1 : 0.5, 1.0));
    }
    moves.drive = [levels, hold_s](double t) {
      return levels[std::min(static_cast<size_t>(t / hold_s), levels.size() - 1)];
    };
  } else if (kind == Kind::chirp) {
    moves.words = "chirp";
    const double first_Hz = 0.3, ratio = std::min(rate_Hz / 8.0, draw.evenly(15.0, 120.0)) / first_Hz;
    moves.drive = [=](double t) {
      return amplitude * std::sin(turn * first_Hz * length_s / std::log(ratio) * (std::pow(ratio, t / length_s) - 1.0));
    };
  } else {
    moves.words = "sines";
    std::vector<std::pair<double, double>> lines;
    const int count = draw.whole(8, 25);
    lines.reserve(static_cast<size_t>(count));
    for (int k = 0; k < count; ++k)
      lines.emplace_back(draw.evenly(0.3, std::min(60.0, rate_Hz / 8.0)), draw.between(0.0, turn));
    moves.drive = [=](double t) {
      double sum = 0.0;
      for (const auto& [Hz, phase] : lines) sum += std::sin(turn * Hz * t + phase);
      return std::clamp(1.6 * amplitude * sum / std::sqrt(static_cast<double>(lines.size())), -most, most);
    };
  }
  return moves;
}

/// From place to place and back, each time at rest, by a course of the fifth order.
Moves placesFrom(const Motor& m, bool ends, double span, double length_s, Draw& draw) {
  struct Leg {
    double from_s, length_s, from, to;
  };
  std::vector<Leg> legs;
  const double fast = 0.5 * m.fastest * draw.evenly(0.2, 0.8), hard = m.peak() / m.inertia * draw.evenly(0.1, 0.5);
  double at_s = 0.0, place = 0.0;
  while (at_s < length_s) {
    const double next = ends ? (place > 0.5 * span ? 0.0 : span) : draw.between(0.0, span),
                 way = std::abs(next - place);
    const double goes_s = std::max({0.05, 1.9 * way / fast, std::sqrt(5.8 * way / hard)});
    legs.push_back({at_s, goes_s, place, next});
    at_s += goes_s + draw.evenly(0.05, 0.5);
    place = next;
  }
  Moves moves;
  moves.words = "places";
  moves.place = true;
  moves.reference = [legs](double t) {
    const auto after = std::find_if(legs.begin(), legs.end(), [t](const Leg& leg) { return leg.from_s > t; });
    const Leg& leg = after == legs.begin() ? *after : *(after - 1);
    const double part = std::clamp((t - leg.from_s) / leg.length_s, 0.0, 1.0);
    return leg.from + (leg.to - leg.from) * part * part * part * (10.0 + part * (6.0 * part - 15.0));
  };
  return moves;
}

Moves movesFrom(const Family& family, const Motor& m, const Concealed& c, bool volts, double length_s, double rate_Hz,
                Draw& draw) {
  auto kind = static_cast<Kind>(draw.whole(0, 5));
  const bool closed = m.linear || family.travels;
  if (closed && kind <= Kind::sines) kind = draw.oneOf(std::array{Kind::speeds, Kind::slowTurns, Kind::places});
  if (c.stopStiffness > 0.0 || (m.linear && kind == Kind::slowTurns)) kind = Kind::places;
  if (kind <= Kind::sines) return openMoves(kind, m, m.inertia + c.loadInertia, volts, length_s, rate_Hz, draw);
  Moves moves;
  if (kind == Kind::places) {
    const double span = m.linear         ? draw.between(0.05, 0.3)
                        : family.travels ? draw.between(6.0, 14.0)
                                         : draw.between(0.5, 6.0);
    moves = placesFrom(m, c.stopStiffness > 0.0 || draw.chance(0.3), span, length_s, draw);
  } else {
    const bool slow = kind == Kind::slowTurns;
    moves.words = slow ? "slow turns" : "speeds";
    double speed = slow ? draw.between(0.8, 4.0) : 0.5 * m.fastest * draw.evenly(0.1, 0.8);
    double period_s = draw.evenly(1.0, 5.0);
    if (m.linear) speed = std::min(speed, 1.0 / period_s);
    if (slow && family.travels) period_s = std::min(length_s, 34.0 / speed);
    moves.reference = [=](double t) {
      const double at = std::fmod(t / period_s, 1.0);
      return speed * (at < 0.25 ? 4.0 * at : at < 0.75 ? 2.0 - 4.0 * at : 4.0 * at - 4.0);
    };
  }
  closeLoop(moves, m, c, volts, rate_Hz, draw);
  return moves;
}

Bench benchFor(const Motor& m, const Driven& driven, Draw& draw) {
  Bench bench;
  bench.name = m.make;
  bench.axis = m.linear ? Axis::linear : Axis::rotary;
  bench.input = driven.input;
  bench.countsPerUnit = m.counts;
  if (driven.input == DriveInput::duty || draw.chance(0.5)) bench.supply_V = m.supply_V;
  const auto roughly = [&](double value) { return value * draw.evenly(0.85, 1.18); };
  const bool exact = draw.chance(0.5), little = draw.chance(0.3);
  if (driven.input != DriveInput::torque) bench.motor.torqueConstant = exact ? m.constant : roughly(m.constant);
  if (driven.volts()) {
    bench.motor.backEmfConstant = bench.motor.torqueConstant;
    bench.motor.resistance_ohm = roughly(m.resistance);
    if (!little) bench.motor.inductance_H = roughly(m.inductance);
  }
  if (draw.chance(0.85)) bench.motor.inertia = roughly(m.inertia);
  if (!little) bench.motor.coulomb = roughly(m.coulomb);
  if (exact && driven.input != DriveInput::torque)
    bench.trusted = {m.linear ? "force_constant_N_per_A" : "torque_constant_Nm_per_A"};
  return bench;
}

Recording logOf(const Rows& rows, const Bench& bench, const Motor& m, const Driven& driven, double missing,
                size_t number, Draw& draw) {
  std::vector<double> time, shown, drive, current;
  for (size_t k = 0; k < rows.time.size(); ++k) {
    if (k > 3 && missing > 0.0 && draw.chance(missing)) continue;
    const double asked = rows.drive[k];
    time.push_back(rows.time[k]);
    shown.push_back(rows.shown[k]);
    drive.push_back(driven.input == DriveInput::duty     ? asked / m.supply_V
                    : driven.input == DriveInput::torque ? asked * m.constant
                    : driven.measured                    ? rows.current[k]
                                                         : asked);
    current.push_back(rows.current[k]);
  }
  std::vector<Channel> channels{{"time_s", time}, {bench.positionChannel(), shown}, {bench.inputChannel(), drive}};
  if (driven.beside) channels.push_back({"current_A", current});
  return *Recording::seal(fmt::format("log {}", number + 1), std::move(channels));
}

}  // namespace

const std::vector<ForeignFamily>& foreignFamilies() {
  static const std::vector<ForeignFamily> all = [] {
    std::vector<ForeignFamily> some;
    for (const Family& family : families()) some.push_back(family.known);
    return some;
  }();
  return all;
}

ForeignRig foreignRig(const std::string& name, std::uint64_t seed) {
  const auto& all = families();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Family& one) { return one.known.name == name; });
  const Family& family = *found;
  Draw draw(name, seed), byChance(name + " by chance", seed);
  const Motor motor = motorFrom(draw, family.rotary);
  Driven driven = draw.oneOf(drives);
  // A delay ahead of a current that is read doesn't show.
  while ((family.volts && !driven.volts()) || (name == "transport_delay" && driven.measured))
    driven = draw.oneOf(drives);
  const double rate_Hz = family.quick ? draw.oneOf(std::array{500.0, 1000.0, 2000.0})
                                      : draw.oneOf(std::array{100.0, 200.0, 250.0, 500.0, 1000.0, 2000.0});
  const size_t logs = name == "external_disturbance" ? 1 : static_cast<size_t>(draw.whole(1, 3));
  const double length_s = std::clamp(15000.0 / rate_Hz / static_cast<double>(logs), 6.0, draw.between(20.0, 40.0));
  const Sensors sensors = sensorsFrom(draw, motor);
  Concealed hidden;
  const std::string size = family.conceal ? family.conceal(hidden, motor, draw, length_s, rate_Hz) : "nothing";
  const Bench bench = benchFor(motor, driven, draw);
  ForeignRig rig{bench, {}, fmt::format("{}, {}, {:.0f} Hz, {:.0f} s:", motor.make, driven.words, rate_Hz, length_s)};
  for (size_t k = 0; k < logs; ++k) {
    Moves moves = movesFrom(family, motor, hidden, driven.volts(), length_s, rate_Hz, draw);
    const auto ran = [&](const Concealed& conceals) {
      return Plant(motor, driven, conceals, sensors, rate_Hz, byChance).run(moves, length_s);
    };
    // Nobody logs an axis that hardly moves.
    constexpr double least = 300.0;  // counts
    for (int tries = 0; tries < 20; ++tries) {
      const Rows rows = ran(hidden);
      if (rows.highest - rows.lowest > least * motor.count()) break;
      moves = movesFrom(family, motor, hidden, driven.volts(), length_s, rate_Hz, draw);
    }
    if (hidden.stopStiffness > 0.0 && k == 0) {  // where it comes to
      Concealed without = hidden;
      without.stopStiffness = without.stopDamping = 0.0;
      const Rows freely = ran(without);
      hidden.high = freely.highest - draw.between(0.04, 0.15) * (freely.highest - freely.lowest);
    }
    const Rows rows = ran(hidden);
    rig.recordings.push_back(logOf(rows, bench, motor, driven, sensors.missing, k, draw));
    rig.words += fmt::format(" {},", moves.words);
  }
  rig.words += fmt::format(" wander {:.1f} %; {}", 100.0 * sensors.wander, size);
  return rig;
}

}  // namespace breakaway::test
