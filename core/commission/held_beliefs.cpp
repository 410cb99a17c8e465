#include "commission/held_beliefs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "identify/map_soundness.h"
#include "motor/beliefs.h"

namespace breakaway {

namespace {

/// By how many bins a position loop may leave a rotor beside the one it was to stand in.
size_t heldReach(const FrictionMap& map, const Identity& board) {
  constexpr double heldWithin = 2.0;  // counts
  if (board.axis == Axis::linear || !(board.countsPerRev > 0.0)) return 0;
  return static_cast<size_t>(std::lround(heldWithin / board.countsPerRev * static_cast<double>(map.bins.size())));
}

/// Every voltage, and with it resistance and back-EMF constant, rides on the supply's reading.
std::optional<Message> wrongSupply(double declared_V, double reads_V) {
  constexpr double tolerance = 0.06;  // of a supply's setting
  const double ratio = reads_V / declared_V;
  if (!(declared_V > 0.0) || std::abs(ratio - 1.0) < tolerance) return {};
  return message(
      "the supply reads {:.4g} V where {:.4g} V belong, {:.3g} times as much: measure it; if it is {:.4g} V, the "
      "board's divider or its reference is off by that factor, and all voltages with it",
      reads_V, declared_V, ratio, declared_V);
}

/// Beliefs, held one after the other.
class Held {
 public:
  Held(const CommissionOptions& options, Commission& known) : options_(options), known_(known) {}

  void bench(BeliefOf of, const char* field, const std::optional<double>& believed, const Estimate& measured,
             const Message& from) {
    if (!believed) return;
    const Belief belief{
        of, message("the bench's"), field, *believed, options_.bench->trusted.contains(field), measured, from};
    hold(belief);
    if (of == BeliefOf::backEmfConstant || of == BeliefOf::torqueConstant) constants_.push_back(ratioOf(belief));
  }
  /// A back-EMF constant is measured per angle that the encoder shows: where all that the bench says of the motor's
  /// constant contradicts alike, and nothing else does, the counts may be wrong as well, and only a whole turn tells.
  void orCounts() {
    constexpr double most = 6.0;  // beyond, it is a unit
    constexpr double alike = 1.2;
    constexpr double edges[] = {4.0, 2.0, 0.5, 0.25};  // of the suggestions, which name the encoder themselves
    const double counts = known_.identity.countsPerRev;
    if (constants_.empty() || found_.size() != constants_.size() || !(counts > 0.0)) return;
    const auto [least, highest] = std::minmax_element(constants_.begin(), constants_.end());
    if (!(*least > 1.0 / most) || !(*highest < most) || !(*highest < alike * *least)) return;
    const double ratio = std::sqrt(*least * *highest);
    if (std::any_of(std::begin(edges), std::end(edges),
                    [&](double one) { return std::abs(std::log(ratio / one)) < nearMistake; }))
      return;
    const Message otherwise =
        known_.linear() ? message(
                              "; or, if the bench is right there, a metre has about {:.3g} counts, not {:.4g}: "
                              "move the axis by a known way and look",
                              ratio * counts, counts)
                        : message(
                              "; or, if the bench is right there, a turn has about {:.0f} counts, not {:.0f}: "
                              "turn the shaft once round by hand and look",
                              ratio * counts, counts);
    found_.back() = found_.back() + otherwise;
  }
  /// What an interrupted job knew of the motor, against what is measured now.
  void earlier(BeliefOf of, const char* field, double before, const Estimate& now) {
    const Belief belief{
        of, message("the interrupted job's"), field, before, true, now, message("but the wiring check's pulses say")};
    if (before > 0.0 && now.value > 0.0) {
      if (const auto parted = contradictionOf(belief, known_.identity.axis))
        take(message("{}; is another motor mounted?", *parted));
    }
  }
  /// What the same pulses said at the beginning. What the bridge hides is the same in both, and most of the doubt with
  /// it.
  void still(BeliefOf of, const char* field, const Estimate& before, const Estimate& now, const Message& from) {
    constexpr double shared = 0.5;  // of both's doubt that isn't
    const double error = shared * std::hypot(now.standardError, now.value * before.standardError / before.value);
    const Belief belief{of, message("at the beginning"), field, before.value, true, {now.value, error}, from};
    if (!(before.value > 0.0) || !(now.value > 0.0)) return;
    const auto parted = contradictionOf(belief, known_.identity.axis);
    if (parted && of == BeliefOf::backEmfConstant) {
      take(message("{}; do the encoder's counts per turn still hold?", *parted));
    } else {
      take(parted);
    }
  }
  void still(const WiringFit& now, const Message& from) {
    const MotorNames& names = motorNames(known_.identity.axis);
    const WiringFit& before = *known_.wiring;
    take(wrongSupply(known_.identity.supply_V, now.supply_V));
    still(BeliefOf::resistance, names.resistance, before.resistance_ohm, now.resistance_ohm, from);
    still(BeliefOf::backEmfConstant, names.backEmfConstant, before.backEmf_V_s_per_rad, now.backEmf_V_s_per_rad, from);
  }
  void take(const std::optional<Message>& contradiction) {
    if (contradiction) found_.push_back(*contradiction);
  }
  bool none() const { return found_.empty(); }

  void hold(const Belief& belief) {
    if (belief.measured.value > 0.0) take(contradictionOf(belief, known_.identity.axis));
  }
  Result<void> conclude() {
    Message all;
    for (const Message& one : found_) {
      all = all + (all.empty() ? "" : "; ") + one;
      if (options_.anyway) known_.contradict(one);
    }
    if (all.empty() || options_.anyway) return {};
    return Error{contradictionPlace, all};
  }

 private:
  const CommissionOptions& options_;
  Commission& known_;
  std::vector<Message> found_;
  std::vector<double> constants_;  ///< believed over measured, of all that the bench says of the motor's constant
};

}  // namespace

Result<void> holdDeclarations(const CommissionOptions& options, Commission& known) {
  if (!options.bench) return {};
  const Bench& bench = *options.bench;
  Held held(options, known);
  held.bench(BeliefOf::counts, motorNames(bench.axis).counts, bench.countsPerUnit, {known.identity.countsPerRev, 0.0},
             message("but the board says"));
  held.bench(BeliefOf::supply, "supply_V", bench.supply_V, {known.identity.supply_V, 0.0},
             message("but the board says"));
  return held.conclude();
}

Result<void> holdWiring(const CommissionOptions& options, Commission& known) {
  const WiringFit& fit = *known.wiring;
  const MotorNames& names = motorNames(known.identity.axis);
  const Message pulses = message("but the wiring check's pulses say");
  Held held(options, known);
  held.take(wrongSupply(known.identity.supply_V, fit.supply_V));
  if (known.knows(Known::motor)) {
    held.earlier(BeliefOf::resistance, names.resistance, known.shownResistance_ohm, fit.resistance_ohm);
    held.earlier(BeliefOf::backEmfConstant, names.backEmfConstant, known.identified.backEmfConstant_V_s_per_rad.value,
                 fit.backEmf_V_s_per_rad);
  }
  if (!options.bench) return held.conclude();
  const MotorBelief& belief = options.bench->motor;
  held.bench(BeliefOf::resistance, names.resistance, belief.resistance_ohm, fit.resistance_ohm, pulses);
  held.bench(BeliefOf::backEmfConstant, names.backEmfConstant, belief.backEmfConstant, fit.backEmf_V_s_per_rad, pulses);
  held.bench(BeliefOf::torqueConstant, names.torqueConstant, belief.torqueConstant, fit.backEmf_V_s_per_rad,
             message("but by the wiring check's pulses the back-EMF constant is"));
  held.orCounts();
  return held.conclude();
}

Result<void> holdWiringStill(const WiringFit& now, const CommissionOptions& options, Commission& known) {
  Held held(options, known);
  held.still(now, message("but at the end"));
  return held.conclude();
}

Message wiringChange(const WiringFit& now, Commission& known) {
  const CommissionOptions strict;
  Held held(strict, known);
  held.still(now, message("but now"));
  const auto same = held.conclude();
  if (same) return {};
  return same.error().fact;
}

Result<void> holdMotor(const IdentifiedMotor& motor, const CommissionOptions& options, Commission& known) {
  if (!options.bench) return {};
  const MotorNames& names = motorNames(options.bench->axis);
  const MotorBelief& belief = options.bench->motor;
  Held held(options, known);
  const Message measured = message("but measured is");
  held.bench(BeliefOf::resistance, names.resistance, belief.resistance_ohm, motor.resistance_ohm, measured);
  held.bench(BeliefOf::inductance, names.inductance, belief.inductance_H, motor.inductance_H, measured);
  held.bench(BeliefOf::backEmfConstant, names.backEmfConstant, belief.backEmfConstant,
             motor.backEmfConstant_V_s_per_rad, measured);
  held.bench(BeliefOf::torqueConstant, names.torqueConstant, belief.torqueConstant, motor.backEmfConstant_V_s_per_rad,
             message("but measured as the back-EMF constant is"));
  held.orCounts();
  // An inertia by a constant that contradicts tells nothing.
  const double scale = motor.backEmfConstant_V_s_per_rad.value / motor.torqueConstant_Nm_per_A.value;
  if (held.none())
    held.bench(BeliefOf::inertia, names.inertia, belief.inertia,
               {scale * motor.inertia_kg_m2.value, scale * motor.inertia_kg_m2.standardError}, measured);
  return held.conclude();
}

Result<void> holdMap(const FrictionMap& map, const CommissionOptions& options, Commission& known) {
  Held held(options, known);
  for (const Message& why : unsoundness(map, heldReach(map, known.identity)))
    held.take(message("this is no friction map: {}", why));
  return held.conclude();
}

}  // namespace breakaway
