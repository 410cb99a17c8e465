#include "diagnose/effects/two_mass.h"

#include <algorithm>
#include <cmath>

#include "base/exact_text.h"

namespace breakaway {

namespace {

constexpr double leastPart = 0.03, mostPart = 0.95;  // of the whole inertia: a smaller load is nobody's finding
constexpr double phasePerPart = 0.2;                 // rad of ω_a per Runge–Kutta step
constexpr double asGoodAsNone = 1e-6;                // of what friction takes from a load's velocity within a step

struct Relative {
  double deflection = 0.0;  // δ, rad
  double velocity = 0.0;    // δ', rad/s
};

/// T/J_load, rad/s².
double pull(const TwoMass& load, const Relative& now) {
  const double stiffness = load.frequency * load.frequency, damping = 2.0 * load.dampingRatio * load.frequency;
  if (load.halfGap <= 0.0) return stiffness * now.deflection + damping * now.velocity;
  const double side = now.deflection > 0.0 ? 1.0 : -1.0;
  const double depth = side * now.deflection - load.halfGap;
  return depth > 0.0 ? side * std::max(0.0, stiffness * depth + damping * side * now.velocity) : 0.0;
}

/// Whether teeth stay apart all the way along δ'' = `acceleration` over dt_s.
bool flies(const TwoMass& load, const Relative& now, double acceleration, double dt_s) {
  const auto apart = [&](double t) {
    return std::abs(now.deflection + t * (now.velocity + 0.5 * t * acceleration)) < load.halfGap;
  };
  if (!apart(0.0) || !apart(dt_s)) return false;
  const double turns_s = acceleration != 0.0 ? -now.velocity / acceleration : -1.0;
  return turns_s <= 0.0 || turns_s >= dt_s || apart(turns_s);
}

Relative flown(const Relative& now, double acceleration, double dt_s) {
  return {now.deflection + dt_s * (now.velocity + 0.5 * dt_s * acceleration), now.velocity + dt_s * acceleration};
}

/// A load's way over some time, while the motor changes its velocity evenly.
class Course {
 public:
  Course(const TwoMass& load, const Relative& now, double motorVelocity, double acceleration)
      : load_(load), now_(now), motor_(motorVelocity), acceleration_(acceleration) {}

  const Relative& now() const { return now_; }
  /// What friction took from the load's velocity, rad/s.
  double lost() const { return lost_; }

  void advance(double dt_s) {
    if (load_.halfGap > 0.0 && flight(dt_s)) return;
    const double stiffest = load_.frequency * std::max(1.0, 2.0 * load_.dampingRatio);
    const double parts = std::clamp(std::ceil(dt_s * stiffest / phasePerPart), 1.0, 1e4);
    for (int part = 0; part < static_cast<int>(parts); ++part) contact(dt_s / parts);
  }

 private:
  double ownVelocity() const { return motor_ - now_.velocity; }
  /// ±1: where friction pushes against; 0: the load rests, or there is no friction.
  double way(double dt_s) const {
    if (deceleration_ <= 0.0) return 0.0;
    const double own = ownVelocity(), pulled = pull(load_, now_);
    if (std::abs(own) > asGoodAsNone * deceleration_ * dt_s) return own > 0.0 ? 1.0 : -1.0;
    return std::abs(pulled) <= deceleration_ ? 0.0 : pulled > 0.0 ? 1.0 : -1.0;
  }
  void rest() { now_.velocity = motor_; }

  /// All of it within the gap, in closed form; false: it isn't, and nothing was done.
  bool flight(double dt_s) {
    if (!flies(load_, now_, acceleration_, dt_s)) return false;
    now_ = flown(now_, acceleration_, dt_s);
    motor_ += dt_s * acceleration_;
    return true;
  }

  /// A part that is short beside 1/ω_a: a fourth-order Runge–Kutta step of δ'' = ω' − T/J_load + way · F_load/J_load.
  void contact(double h) {
    const double way = this->way(h);
    if (deceleration_ > 0.0 && way == 0.0) {
      const double before = pull(load_, now_);
      now_ = flown(now_, acceleration_, h);
      motor_ += h * acceleration_;
      rest();
      lost_ += 0.5 * h * (before + pull(load_, now_));
      return;
    }
    const double braked = acceleration_ + way * deceleration_;
    const auto slope = [&](const Relative& at) { return Relative{at.velocity, braked - pull(load_, at)}; };
    const auto along = [this](const Relative& rate, double s) {
      return Relative{now_.deflection + s * rate.deflection, now_.velocity + s * rate.velocity};
    };
    const Relative a = slope(now_), b = slope(along(a, 0.5 * h)), c = slope(along(b, 0.5 * h)), d = slope(along(c, h));
    now_.deflection += h / 6.0 * (a.deflection + 2.0 * (b.deflection + c.deflection) + d.deflection);
    now_.velocity += h / 6.0 * (a.velocity + 2.0 * (b.velocity + c.velocity) + d.velocity);
    motor_ += h * acceleration_;
    lost_ += way * deceleration_ * h;
    if (way * ownVelocity() < 0.0) {  // it stopped on the way
      lost_ += ownVelocity();
      rest();
    }
  }

  const TwoMass& load_;
  double deceleration_ = load_.friction / load_.inertia;
  Relative now_;
  double motor_;
  double acceleration_;
  double lost_ = 0.0;
};

double stepOf(const TwoMass& load) {
  return std::min(2e-3, (load.halfGap > 0.0 ? 0.2 : 0.3) / load.frequency);  // impacts need finer steps
}

/// The above written down. A load is known by ω_a, ζ, half its gap and F_load/J_load.
const char* const twoMassFunctions = R"(
/// What spring or teeth give the load, per inertia.
function load_pull(deflection, rate, frequency, damping_ratio, half_gap) -> pull {
  stiffness = frequency * frequency;
  damping = 2 * damping_ratio * frequency;
  pull = stiffness * deflection + damping * rate;
  if (half_gap > 0) {
    side = deflection > 0 ? 1 : -1;
    depth = side * deflection - half_gap;
    pull = 0;
    if (depth > 0) { pull = side * max(0, stiffness * depth + damping * side * rate); }
  }
}
/// 1 where teeth stay apart all the way over dt_s.
function load_flies(deflection, rate, acceleration, half_gap, dt_s) -> apart {
  apart = 0;
  landing = deflection + dt_s * (rate + 0.5 * dt_s * acceleration);
  if (abs(deflection) < half_gap && abs(landing) < half_gap) {
    apart = 1;
    turning_s = -1;
    if (acceleration != 0) { turning_s = -rate / acceleration; }
    if (turning_s > 0 && turning_s < dt_s) {
      if (abs(deflection + turning_s * (rate + 0.5 * turning_s * acceleration)) >= half_gap) { apart = 0; }
    }
  }
}
/// The load's way over h, short beside its swinging: a step of Runge and Kutta's fourth order, or rest.
function load_contact(deflection, rate, motor, acceleration, h, frequency, damping_ratio, half_gap, braking) ->
    next_deflection, next_rate, lost {
  own = motor - rate;
  way = 0;
  pulled = load_pull(deflection, rate, frequency, damping_ratio, half_gap);
  if (braking > 0) {
    if (abs(own) > 0.000001 * braking * h) { way = own > 0 ? 1 : -1; }
    else if (abs(pulled) > braking) { way = pulled > 0 ? 1 : -1; }
  }
  if (braking > 0 && way == 0) {
    next_deflection = deflection + h * (rate + 0.5 * h * acceleration);
    next_rate = motor + h * acceleration;
    lost = 0.5 * h * (pulled + load_pull(next_deflection, next_rate, frequency, damping_ratio, half_gap));
  } else {
    braked = acceleration + way * braking;
    a = braked - pulled;
    rate_b = rate + 0.5 * h * a;
    b = braked - load_pull(deflection + 0.5 * h * rate, rate_b, frequency, damping_ratio, half_gap);
    rate_c = rate + 0.5 * h * b;
    c = braked - load_pull(deflection + 0.5 * h * rate_b, rate_c, frequency, damping_ratio, half_gap);
    rate_d = rate + h * c;
    d = braked - load_pull(deflection + h * rate_c, rate_d, frequency, damping_ratio, half_gap);
    next_deflection = deflection + h / 6 * (rate + 2 * (rate_b + rate_c) + rate_d);
    next_rate = rate + h / 6 * (a + 2 * (b + c) + d);
    lost = way * braking * h;
    own = motor + h * acceleration - next_rate;
    if (way * own < 0) {
      lost = lost + own;
      next_rate = motor + h * acceleration;
    }
  }
}
/// The load's way over dt_s while the motor changes its velocity evenly; what friction took from its velocity.
function load_course(deflection, rate, motor, acceleration, dt_s, frequency, damping_ratio, half_gap, braking) ->
    last_deflection, last_rate, lost {
  last_deflection = deflection;
  last_rate = rate;
  if (load_flies(deflection, rate, acceleration, half_gap, dt_s) > 0) {
    last_deflection = deflection + dt_s * (rate + 0.5 * dt_s * acceleration);
    last_rate = rate + dt_s * acceleration;
  } else {
    parts = clamp(ceil(dt_s * frequency * max(1, 2 * damping_ratio) / 0.2), 1, 10000);
    h = dt_s / parts;
    part = 0;
    while (part < parts) {
      (next_deflection, next_rate, taken) = load_contact(last_deflection, last_rate, motor + part * h * acceleration,
        acceleration, h, frequency, damping_ratio, half_gap, braking);
      last_deflection = next_deflection;
      last_rate = next_rate;
      lost = lost + taken;
      part = part + 1;
    }
  }
}
/// What the load gives the motor, the mean around time_s; the memory may be older.
function load_reaction(deflection, rate, motor, remembered_s, time_s, velocity, inertia, longest_s, frequency,
                       damping_ratio, half_gap, braking) -> torque {
  torque = 0;
  if (remembered_s != 0) {
    since_s = min(time_s - remembered_s, longest_s);
    if (since_s <= 0) {
      torque = inertia * load_pull(deflection, rate, frequency, damping_ratio, half_gap);
    } else {
      acceleration = (velocity - motor) / since_s;
      (last_deflection, last_rate, lost) = load_course(deflection, rate, motor, acceleration, 2 * since_s, frequency,
        damping_ratio, half_gap, braking);
      torque = inertia * (acceleration + (lost - (last_rate - rate)) / (2 * since_s));
    }
  }
}
)";

}  // namespace

Term TwoMassEffect::term(std::span<const double> p, const Situation& at) const {
  if (at.memory.size() < size() || at.memory[3] == 0.0) return {};
  const TwoMass load = loadOf(p);
  const Relative now{at.memory[0], at.memory[1]};
  const double since_s = std::min(at.time_s - at.memory[3], stepOf(load));
  if (since_s <= 0.0) return {.load_Nm = load.inertia * pull(load, now)};
  // The mean over the span around `at`, which a step asks for at its middle: an impact gives both sides the same
  // impulse.
  const double acceleration = (at.velocity - at.memory[2]) / since_s;
  Course course(load, now, at.memory[2], acceleration);
  course.advance(2.0 * since_s);
  const double gained = course.lost() - (course.now().velocity - now.velocity);
  return {.load_Nm = load.inertia * (acceleration + gained / (2.0 * since_s))};
}

void TwoMassEffect::remember(std::span<const double> p, const Situation& at, double dt_s,
                             std::span<double> memory) const {
  // At first, and after a jump in time, the load keeps its place and speed relative to the motor.
  const bool continues = at.memory[3] != 0.0 && std::abs(at.time_s - dt_s - at.memory[3]) < 0.5 * dt_s;
  const double acceleration = continues ? (at.velocity - at.memory[2]) / dt_s : at.acceleration;
  const TwoMass load = loadOf(p);
  Course course(load, {at.memory[0], at.memory[1]}, at.velocity - dt_s * acceleration, acceleration);
  course.advance(dt_s);
  memory[0] = course.now().deflection;
  memory[1] = course.now().velocity;
  memory[2] = at.velocity;
  memory[3] = at.time_s;
}

void TwoMassEffect::place(double place, double speed, double velocity, double time_s, std::span<double> memory) const {
  memory[0] = place;
  memory[1] = speed;
  memory[2] = velocity;
  memory[3] = std::max(time_s, 1e-9);  // 0 would mean that nothing is remembered
}

double TwoMassEffect::longestStep_s(std::span<const double> p) const {
  return stepOf(loadOf(p));
}

Written TwoMassEffect::written(std::span<const double> p, Axis axis) const {
  const bool rotary = axis == Axis::rotary;
  const std::string of = loadWritten();
  return {
      .load = "load_reaction(m0, m1, m2, m3, time_s, velocity, p0, " + exactText(stepOf(loadOf(p))) + ", " + of + ")",
      .memory = {rotary ? "deflection_rad" : "deflection_m",
                 rotary ? "deflection_rate_rad_per_s" : "deflection_rate_m_per_s",
                 rotary ? "motor_velocity_rad_per_s" : "motor_velocity_m_per_s", "remembered_at_s"},
      .remember =
          "evenly = acceleration;"
          "if (m3 != 0 && abs(time_s - dt_s - m3) < 0.5 * dt_s) { evenly = (velocity - m2) / dt_s; }"
          "(deflection, rate, lost) = load_course(m0, m1, velocity - dt_s * evenly, evenly, dt_s, " +
          of + "); m0 = deflection; m1 = rate; m2 = velocity; m3 = time_s;",
      .functions = twoMassFunctions};
}

bool plausibleLoad(double inertia, const Excitation& seen) {
  return inertia > 0.0 &&
         (seen.inertia <= 0.0 || (inertia > leastPart * seen.inertia && inertia < mostPart * seen.inertia));
}

}  // namespace breakaway
