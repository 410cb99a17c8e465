// The second way to a rotor's inertia: constant current turns it round.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "commission/motor_tests.h"
#include "commission/steps.h"
#include "experiment/reversal_test.h"
#include "identify/reversal_inertia.h"
#include "identify/spin_disc.h"

namespace breakaway {

namespace {

constexpr double turnsToSpeed = 2.0;  // of a reversal, so that position torque averages out
constexpr double mostRounding =
    0.015;  // of a block's speed by the encoder, of the highest: it chooses the slopes' rows

class Reversal : public Step {
 public:
  Reversal() : Step("reversal test", {Known::windingTest, Known::roughMotor, Known::carefulGains}, {Known::reversal}) {}
  double expected_s(const SweepSettings&) const override { return 5.0; }

  Result<StepRun> begin(OnBench& on) override {
    const IdentifiedMotor& motor = on.known.motor;
    const Identity& board = on.known.identity;
    const double Kt = motor.torqueConstant_Nm_per_A.value, J = motor.inertia_kg_m2.value;
    const double friction_A = std::max(0.01, motor.coulomb_Nm.value / Kt);
    const double most_A = 0.8 * on.known.settings.current_limit_A;
    current_A_ = std::min(3.0 * friction_A, most_A);
    const double slope = Kt * current_A_ / J, free = board.supply_V / motor.backEmfConstant_V_s_per_rad.value;
    ReversalTestOptions options;
    options.current_A = current_A_;
    if (on.known.wiring) {
      for (const auto& breakaway : on.known.wiring->breakaway_A)
        options.breakaway_A = std::max(options.breakaway_A, breakaway ? breakaway->value : 0.0);
    }
    options.highest_rad_per_s =
        std::min(0.5 * free, std::max(0.2 * slope, std::sqrt(turnsToSpeed * 4.0 * std::numbers::pi * slope)));
    const double rounding_rad = turn_rad / board.countsPerRev / std::sqrt(6.0);
    options.block_s = std::max({2.0 / board.loopRate_Hz, options.highest_rad_per_s / slope / 40.0,
                                rounding_rad / (mostRounding * options.highest_rad_per_s)});
    test_ = std::make_shared<ReversalTest>(options);
    return StepRun{"03c-reversal", test_};
  }

  /// Where it can't be gone, the first stands alone, and a remark says so. A rotor that turned in the spin test and
  /// stands now has something in its way.
  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    Commission& known = on.known;
    if (!ran && test_->stood()) return ran.error();
    const auto blocks = freedOf(spinDisc(test_->blocks()), test_->blocks());
    const auto inertia = ran ? reversalInertia(blocks, {known.motor.torqueConstant_Nm_per_A.value, current_A_})
                             : Result<Estimate>(ran.error());
    if (!inertia) {
      known.remark(message("{}; the inertia rests on the spin test alone.", inertia.error().said()));
      return StepEnd::over;
    }
    known.tests->bridge.moving.push_back(blocks);
    if (joinInertia(known.motor, *inertia) > 3.0)
      known.remark(message(
          "The inertia by speeding up and slowing down and the one by turning round differ by more than three standard "
          "errors; the interval given covers both."));
    return StepEnd::over;
  }

 private:
  double current_A_ = 0.0;
  std::shared_ptr<ReversalTest> test_;
};

}  // namespace

StepPtr reversalStep() {
  return std::make_unique<Reversal>();
}

}  // namespace breakaway
