// The current's scale, with its doubt, on the motor: from here on torques are of true amperes, while the windings'
// voltage still follows the current as it is shown.
#include <cmath>

#include "commission/steps.h"

namespace breakaway {

namespace {

CurrentScaleOptions scaleOptions(const CommissionOptions& options, Axis axis) {
  CurrentScaleOptions scale;
  scale.axis = axis;
  if (options.bench) {
    const Bench& bench = *options.bench;
    if (bench.currentGainInterval) scale.gainInterval = *bench.currentGainInterval;
    if (bench.trusted.contains(motorNames(axis).inertia)) scale.trustedInertia_kg_m2 = bench.motor.inertia;
  }
  if (options.against) {
    const Estimate &here = options.addedInertia_kg_m2, &other = options.against->addedInertia_kg_m2;
    scale.added = AddedInertia{options.against->motor.shownInertia_kg_m2,
                               {here.value - other.value, std::hypot(here.standardError, other.standardError)}};
  }
  return scale;
}

class CurrentScale : public Step {
 public:
  CurrentScale() : Step("current's scale", {Known::bridge}, {Known::motor}) {}

  Result<StepEnd> end(OnBench& on, const Result<void>&) override {
    Commission& known = on.known;
    const auto options = scaleOptions(on.options, known.identity.axis);
    known.shownResistance_ohm = known.motor.resistance_ohm.value;
    setCurrentScale(known.motor, options);
    known.remark(known.motor.gauge);
    known.identified = known.motor;
    return StepEnd::over;
  }
};

}  // namespace

StepPtr currentScaleStep() {
  return std::make_unique<CurrentScale>();
}

}  // namespace breakaway
