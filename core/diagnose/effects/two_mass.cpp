#include "diagnose/effects/two_mass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace breakaway {

namespace {

constexpr double leastPart = 0.03, mostPart = 0.95;  // of the whole inertia: a smaller load is nobody's finding
constexpr double phasePerPart = 0.2;                 // rad of ω_a per Runge–Kutta step

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

/// Fourth-order Runge–Kutta steps of δ'' = `acceleration` − T/J_load over dt_s.
Relative advanced(const TwoMass& load, Relative now, double acceleration, double dt_s) {
  if (load.halfGap > 0.0 && flies(load, now, acceleration, dt_s))
    return {now.deflection + dt_s * (now.velocity + 0.5 * dt_s * acceleration), now.velocity + dt_s * acceleration};
  const double stiffest = load.frequency * std::max(1.0, 2.0 * load.dampingRatio);
  const double parts = std::clamp(std::ceil(dt_s * stiffest / phasePerPart), 1.0, 1e4);
  const double h = dt_s / parts;
  const auto slope = [&](const Relative& at) { return Relative{at.velocity, acceleration - pull(load, at)}; };
  const auto along = [&now](const Relative& rate, double s) {
    return Relative{now.deflection + s * rate.deflection, now.velocity + s * rate.velocity};
  };
  for (int part = 0; part < static_cast<int>(parts); ++part) {
    const Relative a = slope(now), b = slope(along(a, 0.5 * h)), c = slope(along(b, 0.5 * h)), d = slope(along(c, h));
    now.deflection += h / 6.0 * (a.deflection + 2.0 * (b.deflection + c.deflection) + d.deflection);
    now.velocity += h / 6.0 * (a.velocity + 2.0 * (b.velocity + c.velocity) + d.velocity);
  }
  return now;
}

}  // namespace

Term twoMassTerm(const TwoMass& load, const Situation& at) {
  if (at.memory.size() < twoMassMemory || at.memory[3] == 0.0) return {};
  const Relative now{at.memory[0], at.memory[1]};
  const double since_s = std::min(at.time_s - at.memory[3], twoMassStep_s(load));
  if (since_s <= 0.0) return {.load_Nm = load.inertia * pull(load, now)};
  // The mean over the span around `at`, which a step asks for at its middle: an impact gives both sides the same
  // impulse.
  const double acceleration = (at.velocity - at.memory[2]) / since_s;
  const Relative later = advanced(load, now, acceleration, 2.0 * since_s);
  return {.load_Nm = load.inertia * (acceleration - (later.velocity - now.velocity) / (2.0 * since_s))};
}

void twoMassRemember(const TwoMass& load, const Situation& at, double dt_s, std::span<double> memory) {
  // At first, and after a jump in time, the load keeps its place and speed relative to the motor.
  const bool continues = at.memory[3] != 0.0 && std::abs(at.time_s - dt_s - at.memory[3]) < 0.5 * dt_s;
  const double acceleration = continues ? (at.velocity - at.memory[2]) / dt_s : at.acceleration;
  const Relative now = advanced(load, {at.memory[0], at.memory[1]}, acceleration, dt_s);
  memory[0] = now.deflection;
  memory[1] = now.velocity;
  memory[2] = at.velocity;
  memory[3] = at.time_s;
}

void placeTwoMass(double deflection, double speed, double velocity, double time_s, std::span<double> memory) {
  memory[0] = deflection;
  memory[1] = speed;
  memory[2] = velocity;
  memory[3] = std::max(time_s, 1e-9);  // 0 would mean that nothing is remembered
}

double twoMassPeriod_s(const TwoMass& load) {
  return 2.0 * std::numbers::pi / load.frequency;
}

double twoMassStep_s(const TwoMass& load) {
  return std::min(2e-3, (load.halfGap > 0.0 ? 0.2 : 0.3) / load.frequency);  // impacts need finer steps
}

bool plausibleLoad(double inertia, const Excitation& seen) {
  return inertia > 0.0 &&
         (seen.inertia <= 0.0 || (inertia > leastPart * seen.inertia && inertia < mostPart * seen.inertia));
}

}  // namespace breakaway
