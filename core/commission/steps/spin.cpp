// Back-EMF constant, inertia and average friction of a rotor, by voltage up and down both ways.
#include <algorithm>
#include <cmath>

#include "commission/held_beliefs.h"
#include "commission/motor_tests.h"
#include "commission/steps.h"
#include "experiment/spin_test.h"
#include "identify/spin_disc.h"

namespace breakaway {

namespace {

double highestSpeed(const std::vector<SpinBlock>& blocks) {
  double highest = 0.0;
  for (size_t k = 1; k < blocks.size(); ++k) {
    highest = std::max(highest, std::abs(blocks[k].angle_rad - blocks[k - 1].angle_rad) / blocks[k].duration_s);
  }
  return highest;
}

class Spin : public Step {
 public:
  Spin() : Step("spin test", {Known::sensorZero, Known::windingTest}, {Known::roughMotor}) {}
  double expected_s(const SweepSettings&) const override { return 24.0; }

  Result<StepRun> begin(OnBench& on) override {
    const WindingFit& fit = on.known.tests->winding;
    if (!spin_) {
      // Where friction takes much of the supply, half of it would hardly turn the rotor.
      const double moving_V = fit.line.voltageFor(fit.friction_A()), supply_V = on.known.identity.supply_V;
      options_.highest_V = std::clamp(2.5 * moving_V, 0.5 * supply_V, 0.9 * supply_V);
    } else {
      // A heavy rotor doesn't come up to speed in so short a leg.
      slowly_ = true;
      options_.leg_s *= 5.0;
      options_.cycles = 2;
    }
    spin_ = std::make_shared<SpinTest>(options_);
    return StepRun{slowly_ ? "03b-spin-slowly" : "03-spin", spin_};
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    Commission& known = on.known;
    MotorTests& tests = *known.tests;
    MotorIdentificationOptions options;
    options.trustedTorqueConstant_Nm_per_A = trustedConstant(on.options);
    options.count_rad = tests.bridge.count_rad;
    const auto blocks = freedOf(spinDisc(spin_->blocks()), spin_->blocks());
    const auto motor = identifyMotor(blocks, tests.winding.line, tests.winding.timeConstant_s, options);
    const bool slow =
        !motor || highestSpeed(blocks) * motor->backEmfConstant_V_s_per_rad.value < 0.3 * known.identity.supply_V;
    if (slow && !slowly_) return StepEnd::again;
    if (!motor) return Error{"03-spin", motor.error().message()};
    if (auto held = holdMotor(*motor, on.options, known); !held) return held.error();
    known.motor = tests.rough = *motor;
    tests.bridge.moving = {blocks};
    const double Kt = motor->torqueConstant_Nm_per_A.value, Ke = motor->backEmfConstant_V_s_per_rad.value;
    if (std::abs(Kt - Ke) > 0.05 * Ke)
      known.remark(message(
          "The trusted torque constant and the measured back-EMF constant differ by more than 5 %; in SI they are the "
          "same quantity. All torques rest on the trusted one."));
    return StepEnd::over;
  }

 private:
  SpinTestOptions options_;
  bool slowly_ = false;
  std::shared_ptr<SpinTest> spin_;
};

}  // namespace

StepPtr spinStep() {
  return std::make_unique<Spin>();
}

}  // namespace breakaway
