#include "commission/axis_identification.h"

#include <algorithm>

#include "identify/travel_mass.h"

namespace breakaway {

namespace {

constexpr double leastMotion_m = 1e-4;  // of the winding test
constexpr double stretch_s = 0.05;      // in which a stroke's voltage goes down and up, at least

double countOf(const Identity& board) {
  return 1.0 / board.countsPerRev;
}

/// As setCurrentScale() says it of a rotor.
std::string onAnAxis(std::string text) {
  constexpr std::pair<const char*, const char*> words[] = {
      {"torques", "forces"}, {"disc of known inertia", "known added mass"}, {"inertia", "mass"}};
  for (const auto& [rotors, linear] : words) {
    for (size_t at = text.find(rotors); at != std::string::npos; at = text.find(rotors, at))
      text.replace(at, std::string(rotors).size(), linear);
  }
  return text;
}

}  // namespace

TravelSearchOptions searchOn(const Identity& board, const ControllerSettings& settings) {
  TravelSearchOptions options;
  options.mostLimit_A = settings.current_limit_A;
  options.firstLimit_A = 0.02 * options.mostLimit_A;
  options.count_m = countOf(board);
  return options;
}

WindingTestOptions windingTestOn(const Identity& board) {
  WindingTestOptions options;
  options.motion_rad = std::max(leastMotion_m, 8.0 * countOf(board));
  options.axis = Axis::linear;
  return options;
}

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

Result<IdentifiedMotor> identifyAxis(const AxisTests& tests, std::vector<std::string>& remarks) {
  MotorIdentificationOptions options;
  options.trustedTorqueConstant_Nm_per_A = tests.trustedForceConstant_N_per_A;
  options.window_s = 10.0 * tests.block_s;
  auto motor = identifyMotor(tests.strokes, tests.winding.line, tests.winding.timeConstant_s, options);
  if (!motor) return motor.error();
  BridgeTests bridgeTests;
  bridgeTests.standing = tests.standing;
  bridgeTests.moving = {tests.strokes};
  bridgeTests.timeConstant_s = tests.winding.timeConstant_s.value;
  bridgeTests.supply_V = tests.supply_V;
  const auto bridge = fitBridge(bridgeTests);
  if (bridge) {
    takeBridge(*motor, *bridge, tests.winding.timeConstant_s);
  } else {
    remarks.push_back(bridge.error().message() +
                      "; resistance and back-EMF constant rest on a straight line beyond the dead zone.");
  }
  const auto mass = massByStrokes(tests.strokes, motor->torqueConstant_Nm_per_A.value);
  if (!mass) return mass.error();
  motor->rampInertia_kg_m2 = motor->inertia_kg_m2 = *mass;
  return motor;
}

void setAxisScale(IdentifiedMotor& motor, const CurrentScaleOptions& options) {
  setCurrentScale(motor, options);
  motor.gauge = onAnAxis(motor.gauge);
}

}  // namespace breakaway
