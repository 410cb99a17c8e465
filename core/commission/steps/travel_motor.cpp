// The motor, the bridge and the mass of a linear axis, by strokes by voltage.
#include <algorithm>

#include "commission/held_beliefs.h"
#include "commission/motor_tests.h"
#include "commission/steps.h"
#include "experiment/travel_strokes.h"
#include "identify/travel_mass.h"

namespace breakaway {

namespace {

constexpr double stretch_s = 0.05;  // in which a stroke's voltage goes down and up, at least

/// Strokes by three voltages that friction, supply and name plate allow over this travel.
TravelStrokesOptions strokesOn(const Identity& board, const ControllerSettings& settings, const Travel& travel,
                               const WindingFit& winding) {
  const double supply_V = board.supply_V;
  TravelStrokesOptions options;
  options.travel = travel;
  // Where friction takes much of the supply, half of it would hardly move the axis.
  // On a short axis slower, and with fewer changes, so that the current can follow them; by the name plate. Below a
  // third of the supply the bridge's curve can't be told.
  const double low_V = winding.line.voltageFor(1.3 * winding.friction_A()),
               Ke = settings.nominal_torque_constant_Nm_per_A;
  const double quick_V = 1.5 * low_V + Ke * options.stretch * travel.usable_m() / stretch_s;
  const double most_V =
      std::min(std::max(0.35 * supply_V, quick_V), std::clamp(3.0 * low_V, 0.5 * supply_V, 0.9 * supply_V));
  options.stretch = std::clamp(stretch_s * (most_V - 1.5 * low_V) / Ke / travel.usable_m(), options.stretch, 0.6);
  options.least_V = std::min(low_V, most_V);
  for (const double part : {0.3, 0.6, 1.0})
    options.voltages_V.push_back(options.least_V + part * (most_V - options.least_V));
  return options;
}

/// Motor, bridge and mass, with the current as the sensor shows it. Errors: those of identifyMotor() and
/// massByStrokes().
Result<IdentifiedMotor> identify(const MotorTests& tests, double block_s, std::optional<double> trusted_N_per_A,
                                 Commission& known) {
  const std::vector<SpinBlock>& strokes = tests.bridge.moving.front();
  MotorIdentificationOptions options;
  options.count_rad = tests.bridge.count_rad;
  options.trustedTorqueConstant_Nm_per_A = trusted_N_per_A;
  options.window_s = 10.0 * block_s;
  auto motor = identifyMotor(strokes, tests.winding.line, tests.winding.timeConstant_s, options);
  if (!motor) return motor.error();
  takeBridge(tests, *motor, known);
  const auto mass = massByStrokes(strokes, motor->torqueConstant_Nm_per_A.value);
  if (!mass) return mass.error();
  motor->rampInertia_kg_m2 = motor->inertia_kg_m2 = *mass;
  return motor;
}

class TravelMotor : public Step {
 public:
  TravelMotor() : Step("strokes by voltage", {Known::ends, Known::windingTest}, {Known::roughMotor, Known::bridge}) {}
  double expected_s(const SweepSettings&) const override { return 12.0; }

  Result<StepRun> begin(OnBench& on) override {
    const auto options = strokesOn(on.known.identity, on.drive.settings(), on.known.counted, on.known.tests->winding);
    block_s_ = options.block_s;
    strokes_ = std::make_shared<TravelStrokes>(options);
    return StepRun{"04-strokes", strokes_};
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    MotorTests& tests = *on.known.tests;
    tests.bridge.moving = {strokes_->blocks()};
    const auto motor = identify(tests, block_s_, trustedConstant(on.options), on.known);
    if (!motor) return Error{"04-strokes", motor.error().message()};
    if (auto held = holdMotor(*motor, on.options, on.known); !held) return held.error();
    on.known.motor = *motor;
    return StepEnd::over;
  }

 private:
  double block_s_ = 0.0;
  std::shared_ptr<TravelStrokes> strokes_;
};

}  // namespace

StepPtr travelMotorStep() {
  return std::make_unique<TravelMotor>();
}

}  // namespace breakaway
