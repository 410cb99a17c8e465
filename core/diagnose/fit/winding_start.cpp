#include "diagnose/fit/winding_start.h"

#include <algorithm>
#include <optional>

#include "diagnose/fit/shown_winding.h"

namespace breakaway {

namespace {

constexpr double farOff = 2.0, inductanceFarOff = 5.0;  ///< times what is seen, or a part of it
constexpr double usual_s[]{3e-4, 1e-3, 3e-3};           ///< time constants of windings

bool isFarOff(const std::optional<double>& believed, double seen, double by) {
  return !believed || *believed > by * seen || *believed < seen / by;
}

/// With what the current shows in the place of what isn't trusted. The torque constant keeps its ratio to the back-EMF
/// constant.
Bench withWinding(Bench bench, const ShownWinding& seen) {
  const MotorNames& names = motorNames(bench.axis);
  MotorBelief& motor = bench.motor;
  const auto trusts = [&bench](const char* name) { return bench.trusted.count(name) > 0; };
  if (!trusts(names.resistance)) motor.resistance_ohm = seen.resistance_ohm.value;
  if (!trusts(names.inductance)) motor.inductance_H = seen.inductance_H;
  if (trusts(names.backEmfConstant)) return bench;
  const double before = motor.backEmfConstant.value_or(motor.torqueConstant.value_or(seen.backEmf.value));
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
  const MotorBelief& motor = bench.motor;
  if (currentSeen) {
    const auto seen = shownWinding(tracks);
    if (!seen || !(seen->resistance_ohm.value > 0.0) || !(seen->backEmf.value > 0.0)) return {{bench}, {}};
    const bool off =
        isFarOff(motor.resistance_ohm, seen->resistance_ohm.value, farOff) ||
        isFarOff(motor.inductance_H, seen->inductance_H, inductanceFarOff) ||
        isFarOff(motor.backEmfConstant ? motor.backEmfConstant : motor.torqueConstant, seen->backEmf.value, farOff);
    return {{off ? withWinding(bench, *seen) : bench}, {seen->leastInductance_H, seen->mostInductance_H}};
  }
  std::vector<Bench> benches{bench};
  if (motor.inductance_H) return {benches, {}};
  for (const double time_s : usual_s) {
    benches.push_back(bench);
    benches.back().motor.inductance_H = time_s * motor.resistance_ohm.value_or(1.0);
  }
  return {benches, {}};
}

}  // namespace breakaway
