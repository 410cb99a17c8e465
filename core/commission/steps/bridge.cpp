// Winding and bridge of a rotor once more, from all tests together; and the bridge's curve, where it has one, to the
// board.
#include "base/numbers.h"
#include "commission/motor_tests.h"
#include "commission/steps.h"

namespace breakaway {

namespace {

constexpr double worthSaying = 0.01;  // relative standard error
constexpr double usualBend = 0.04;    // likewise, of a back-EMF constant by a bridge that bends as bridges do

class Bridge : public Step {
 public:
  Bridge() : Step("bridge", {Known::windingTest, Known::roughMotor, Known::reversal}, {Known::bridge}) {}

  Result<StepEnd> end(OnBench& on, const Result<void>&) override {
    takeBridge(*on.known.tests, on.known.motor, on.known);
    return StepEnd::over;
  }
};

class Straighten : public Step {
 public:
  Straighten() : Step("straightened bridge", {Known::bridge}, {Known::straight}) {}

  Result<StepEnd> end(OnBench& on, const Result<void>&) override {
    Commission& known = on.known;
    known.linearised = false;
    if (!known.motor.dutyCurve.known()) return StepEnd::over;
    const auto taken = on.drive.linearise(known.motor.dutyCurve);
    known.linearised = taken.ok();
    if (known.linearised) {
      known.remark(
          message("The bridge bends its duty: the board takes its voltages through the measured curve's inverse."));
      return StepEnd::over;
    }
    known.remark(message("The bridge bends its duty, and the board can't straighten it ({}): {}", taken.error().fact,
                         known.linear() ? message("breakaway ramps are made along a straight line.")
                                        : message("breakaway ramps follow its tangent at the breakaway current.")));
    return StepEnd::over;
  }
};

}  // namespace

void takeBridge(const MotorTests& tests, IdentifiedMotor& motor, Commission& known) {
  const auto bridge = fitBridge(tests.bridge);
  if (bridge) {
    takeBridge(motor, *bridge, tests.winding.timeConstant_s);
  } else {
    known.remark(message("{}; resistance and back-EMF constant rest on a straight line beyond the dead zone.",
                         bridge.error().said()));
    const double Ke = motor.backEmfConstant_V_s_per_rad.value;
    const double doubt = widenByBridge(motor, backEmfOfAnyCurve(tests.bridge).value_or(Estimate{Ke, usualBend * Ke}));
    if (doubt < worthSaying) return;
    known.remark(
        motor.torqueConstantTrusted
            ? message("How a bridge bends its duty leaves the back-EMF constant open by ±{:.2g} %.",
                      100.0 * normal95 * doubt)
        : known.linear()
            ? message("How a bridge bends its duty leaves the back-EMF constant, and with it all forces, open "
                      "by ±{:.2g} %; a force constant that is trusted would not.",
                      100.0 * normal95 * doubt)
            : message("How a bridge bends its duty leaves the back-EMF constant, and with it all torques, open "
                      "by ±{:.2g} %; a torque constant that is trusted would not.",
                      100.0 * normal95 * doubt));
  }
}

StepPtr bridgeStep() {
  return std::make_unique<Bridge>();
}

StepPtr straightenStep() {
  return std::make_unique<Straighten>();
}

}  // namespace breakaway
