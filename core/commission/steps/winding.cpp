// Resistance, dead zone and time constant of the standing motor, and a first look at its breakaway current.
#include <algorithm>

#include "base/numbers.h"
#include "commission/motor_tests.h"
#include "commission/steps.h"
#include "experiment/winding_test.h"

namespace breakaway {

namespace {

constexpr double leastMotion_m = 1e-4;  // of a linear axis
constexpr double motionCounts = 2.5;    // of a rotor's, at least: one may be play, or what still swung

WindingTestOptions optionsOnAxis(const Identity& board) {
  WindingTestOptions options;
  options.motion_rad = std::max(leastMotion_m, 8.0 / board.countsPerRev);
  options.axis = Axis::linear;
  return options;
}

WindingTestOptions optionsOnRotor(const Identity& board) {
  WindingTestOptions options;
  options.motion_rad = std::max(options.motion_rad, motionCounts * turn_rad / board.countsPerRev);
  return options;
}

class Winding : public Step {
 public:
  Winding() : Step("winding test", {Known::sensorZero, Known::wiring}, {Known::windingTest}) {}
  double expected_s(const SweepSettings&) const override { return 30.0; }

  Result<StepRun> begin(OnBench& on) override {
    const bool linear = on.known.linear();
    name_ = linear ? "03-winding" : "02-winding";
    auto options = linear ? optionsOnAxis(on.known.identity) : optionsOnRotor(on.known.identity);
    options.noise_A = on.known.noiseRms_A;
    test_ = std::make_shared<WindingTest>(options);
    return StepRun{name_, test_};
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    const auto fit = fitWinding(*test_);
    if (!fit) return Error{name_, fit.error().message()};
    on.known.expected_A = fit->expected_A;
    auto tests = std::make_shared<MotorTests>();
    tests->winding = *fit;
    tests->bridge.standing = test_->points();
    tests->bridge.timeConstant_s = fit->timeConstant_s.value;
    tests->bridge.supply_V = on.known.identity.supply_V;
    tests->bridge.count_rad = (on.known.linear() ? 1.0 : turn_rad) / on.known.identity.countsPerRev;
    on.known.tests = tests;
    return StepEnd::over;
  }

 private:
  std::string name_;
  std::shared_ptr<WindingTest> test_;
};

}  // namespace

StepPtr windingStep() {
  return std::make_unique<Winding>();
}

}  // namespace breakaway
