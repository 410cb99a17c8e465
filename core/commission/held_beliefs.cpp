#include "commission/held_beliefs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "identify/map_soundness.h"
#include "motor/beliefs.h"

namespace breakaway {

namespace {

/// Beliefs, held one after the other.
class Held {
 public:
  Held(const CommissionOptions& options, Commission& known) : options_(options), known_(known) {}

  void bench(BeliefOf of, const char* field, const std::optional<double>& believed, const Estimate& measured,
             const std::string& from) {
    if (believed) hold({of, "the bench's", field, *believed, options_.bench->trusted.contains(field), measured, from});
  }
  void take(const std::optional<std::string>& contradiction) {
    if (contradiction) found_.push_back(*contradiction);
  }
  bool none() const { return found_.empty(); }

  void hold(const Belief& belief) {
    if (belief.measured.value > 0.0) take(contradictionOf(belief, known_.identity.axis));
  }
  Result<void> conclude() {
    std::string all;
    for (const std::string& one : found_) {
      all += (all.empty() ? "" : "; ") + one;
      if (options_.anyway) known_.contradict(one);
    }
    if (all.empty() || options_.anyway) return {};
    return Error{contradictionPlace, all};
  }

 private:
  const CommissionOptions& options_;
  Commission& known_;
  std::vector<std::string> found_;
};

}  // namespace

Result<void> holdDeclarations(const CommissionOptions& options, Commission& known) {
  if (!options.bench) return {};
  const Bench& bench = *options.bench;
  Held held(options, known);
  held.bench(BeliefOf::counts, motorNames(bench.axis).counts, bench.countsPerUnit, {known.identity.countsPerRev, 0.0},
             "but the board says");
  held.bench(BeliefOf::supply, "supply_V", bench.supply_V, {known.identity.supply_V, 0.0}, "but the board says");
  return held.conclude();
}

Result<void> holdMotor(const IdentifiedMotor& motor, const CommissionOptions& options, Commission& known) {
  if (!options.bench) return {};
  const MotorNames& names = motorNames(options.bench->axis);
  const MotorBelief& belief = options.bench->motor;
  Held held(options, known);
  const std::string measured = "but measured is";
  held.bench(BeliefOf::resistance, names.resistance, belief.resistance_ohm, motor.resistance_ohm, measured);
  held.bench(BeliefOf::inductance, names.inductance, belief.inductance_H, motor.inductance_H, measured);
  held.bench(BeliefOf::backEmfConstant, names.backEmfConstant, belief.backEmfConstant,
             motor.backEmfConstant_V_s_per_rad, measured);
  held.bench(BeliefOf::torqueConstant, names.torqueConstant, belief.torqueConstant, motor.backEmfConstant_V_s_per_rad,
             "but measured as the back-EMF constant is");
  // An inertia by a constant that contradicts tells nothing.
  const double scale = motor.backEmfConstant_V_s_per_rad.value / motor.torqueConstant_Nm_per_A.value;
  if (held.none())
    held.bench(BeliefOf::inertia, names.inertia, belief.inertia,
               {scale * motor.inertia_kg_m2.value, scale * motor.inertia_kg_m2.standardError}, measured);
  return held.conclude();
}

Result<void> holdMap(const FrictionMap& map, const CommissionOptions& options, Commission& known) {
  Held held(options, known);
  for (const std::string& why : unsoundness(map)) held.take("this is no friction map: " + why);
  return held.conclude();
}

}  // namespace breakaway
