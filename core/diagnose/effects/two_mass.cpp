#include "diagnose/effects/two_mass.h"

#include <algorithm>
#include <cmath>

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

bool plausibleLoad(double inertia, const Excitation& seen) {
  return inertia > 0.0 &&
         (seen.inertia <= 0.0 || (inertia > leastPart * seen.inertia && inertia < mostPart * seen.inertia));
}

}  // namespace breakaway
