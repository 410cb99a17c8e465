#include "diagnose/fit/winding_start.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnose/fit/shown_winding.h"

namespace breakaway {

namespace {

constexpr double farOff = 2.0;  ///< times what is seen, or a part of it, beyond its doubt
constexpr double standardErrors = 3.0;
constexpr double usual_s[]{3e-4, 1e-3, 3e-3};  ///< time constants of windings

/// Whether a bench that doesn't know better should begin from what is seen.
bool isFarOff(const std::optional<double>& believed, double least, double most) {
  return !believed || *believed > farOff * most || *believed < least / farOff;
}

bool isFarOff(const std::optional<double>& believed, const Estimate& seen) {
  const double doubt = std::exp(standardErrors * seen.standardError / seen.value);
  return isFarOff(believed, seen.value / doubt, seen.value * doubt);
}

/// With what the current shows in the place of what isn't trusted and far off. The torque constant keeps its ratio to
/// the back-EMF constant.
Bench withWinding(Bench bench, const ShownWinding& seen) {
  const MotorNames& names = motorNames(bench.axis);
  MotorBelief& motor = bench.motor;
  const auto trusts = [&bench](const char* name) { return bench.trusted.count(name) > 0; };
  if (!trusts(names.resistance) && isFarOff(motor.resistance_ohm, seen.resistance_ohm))
    motor.resistance_ohm = seen.resistance_ohm.value;
  if (!trusts(names.inductance) && isFarOff(motor.inductance_H, seen.leastInductance_H, seen.mostInductance_H))
    motor.inductance_H = seen.inductance_H;
  const std::optional<double> constant = motor.backEmfConstant ? motor.backEmfConstant : motor.torqueConstant;
  if (trusts(names.backEmfConstant) || !isFarOff(constant, seen.backEmf)) return bench;
  const double before = constant.value_or(seen.backEmf.value);
  if (!trusts(names.torqueConstant))
    motor.torqueConstant = motor.torqueConstant.value_or(before) * seen.backEmf.value / before;
  motor.backEmfConstant = seen.backEmf.value;
  return bench;
}

}  // namespace

StartingWindings startingWindings(const Bench& bench, const std::vector<Track>& tracks) {
  if (!bench.electrical()) return {{bench}, {}};
  const bool currentSeen =
      std::all_of(tracks.begin(), tracks.end(), [](const Track& one) { return !one.current.empty(); });
  if (currentSeen) {
    const auto seen = shownWinding(tracks);
    if (!seen || !(seen->resistance_ohm.value > 0.0) || !(seen->backEmf.value > 0.0)) return {{bench}, {}};
    return {{withWinding(bench, *seen)}, {seen->leastInductance_H, seen->mostInductance_H}};
  }
  std::vector<Bench> benches{bench};
  if (bench.motor.inductance_H) return {benches, {}};
  for (const double time_s : usual_s) {
    benches.push_back(bench);
    benches.back().motor.inductance_H = time_s * bench.motor.resistance_ohm.value_or(1.0);
  }
  return {benches, {}};
}

}  // namespace breakaway
