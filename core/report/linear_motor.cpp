// The motor's chapter of a linear axis' commissioning: zero, ends, winding, strokes, scale, tuning.
#include <algorithm>
#include <cmath>
#include <memory>

#include "control/tuning.h"
#include "experiment/current_zeroing.h"
#include "experiment/travel_search.h"
#include "experiment/travel_strokes.h"
#include "experiment/winding_test.h"
#include "identify/bridge_fit.h"
#include "identify/travel_mass.h"
#include "report/commission_begin.h"
#include "report/linear_job.h"

namespace breakaway {

namespace {

constexpr double leastMotion_m = 1e-4;  // of the winding test
constexpr double stretch_s = 0.05;      // in which a stroke's voltage goes down and up, at least

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

Result<void> LinearJob::zero() {
  const auto zeroing = std::make_shared<CurrentZeroing>();
  if (auto ran = steps_.run("01-zero", zeroing, 0.002); !ran) return ran;
  done_.noiseRms_A = zeroing->noiseRms_A();
  done_.sensorZero_A = zeroing->zero_A();
  return {};
}

Result<void> LinearJob::findEnds() {
  TravelSearchOptions options;
  options.mostLimit_A = drive_.settings().current_limit_A;
  options.firstLimit_A = 0.02 * options.mostLimit_A;
  options.count_m = count_m();
  const auto search = std::make_shared<TravelSearch>(options);
  if (auto ran = steps_.run("02-ends", search, 0.02); !ran) return ran;
  travel_ = search->travel();
  done_.travel = travel_;
  return {};
}

Result<void> LinearJob::identify() {
  if (kept_.motor) {
    done_.motor = *kept_.motor;
    expected_A_ = kept_.expected_A;
    shownResistance_ohm_ = kept_.shownResistance_ohm;
    return {};
  }
  WindingTestOptions windingOptions;
  windingOptions.motion_rad = std::max(leastMotion_m, 8.0 * count_m());
  windingOptions.axis = Axis::linear;
  const auto winding = std::make_shared<WindingTest>(windingOptions);
  if (auto ran = steps_.run("03-winding", winding, 0.02); !ran) return ran;
  const auto line = fitWindingLine(winding->points());
  if (!line) return Error{"03-winding", line.error().message()};
  const auto constant = fitTimeConstant(winding->squareResponse_A(), winding->squareTick_s());
  if (!constant) return Error{"03-winding", constant.error().message()};
  for (size_t way = 0; way < 2; ++way) {
    for (const double one : winding->breakaway_A()[way]) expected_A_[way] = std::max(expected_A_[way], one);
  }
  const double supply_V = drive_.identity().supply_V, friction_A = std::max(expected_A_[0], expected_A_[1]);
  TravelStrokesOptions strokesOptions;
  strokesOptions.travel = travel_;
  // Where friction takes much of the supply, half of it would hardly move the axis.
  // On a short axis slower, and with fewer changes, so that the current can follow them; by the name plate. Below a
  // third of the supply the bridge's curve can't be told.
  const double low_V = line->voltageFor(1.3 * friction_A), Ke = drive_.settings().nominal_torque_constant_Nm_per_A;
  const double quick_V = 1.5 * low_V + Ke * strokesOptions.stretch * travel_.usable_m() / stretch_s;
  const double most_V =
      std::min(std::max(0.35 * supply_V, quick_V), std::clamp(3.0 * low_V, 0.5 * supply_V, 0.9 * supply_V));
  strokesOptions.stretch =
      std::clamp(stretch_s * (most_V - 1.5 * low_V) / Ke / travel_.usable_m(), strokesOptions.stretch, 0.6);
  strokesOptions.least_V = std::min(low_V, most_V);
  for (const double part : {0.3, 0.6, 1.0})
    strokesOptions.voltages_V.push_back(strokesOptions.least_V + part * (most_V - strokesOptions.least_V));
  const auto strokes = std::make_shared<TravelStrokes>(strokesOptions);
  if (auto ran = steps_.run("04-strokes", strokes, 0.03); !ran) return ran;
  MotorIdentificationOptions motorOptions;
  motorOptions.trustedTorqueConstant_Nm_per_A = trustedConstant(options_);
  motorOptions.window_s = 10.0 * strokesOptions.block_s;
  auto motor = identifyMotor(strokes->blocks(), *line, *constant, motorOptions);
  if (!motor) return Error{"04-strokes", motor.error().message()};
  done_.motor = *motor;
  BridgeTests tests;
  tests.standing = winding->points();
  tests.moving = {strokes->blocks()};
  tests.timeConstant_s = constant->value;
  tests.supply_V = supply_V;
  const auto bridge = fitBridge(tests);
  if (bridge) {
    takeBridge(done_.motor, *bridge, *constant);
  } else {
    done_.remarks.push_back(bridge.error().message() +
                            "; resistance and back-EMF constant rest on a straight line beyond the dead zone.");
  }
  const auto mass = massByStrokes(strokes->blocks(), done_.motor.torqueConstant_Nm_per_A.value);
  if (!mass) return Error{"04-strokes", mass.error().message()};
  done_.motor.rampInertia_kg_m2 = done_.motor.inertia_kg_m2 = *mass;
  return setScale();
}

Result<void> LinearJob::setScale() {
  CurrentScaleOptions options;
  if (options_.bench) {
    if (options_.bench->currentGainInterval) options.gainInterval = *options_.bench->currentGainInterval;
    if (options_.bench->trusted.contains("mass_kg")) options.trustedInertia_kg_m2 = options_.bench->motor.inertia;
  }
  if (options_.against) {
    const Estimate &here = options_.addedInertia_kg_m2, &other = options_.against->addedInertia_kg_m2;
    options.added = AddedInertia{options_.against->motor.shownInertia_kg_m2,
                                 {here.value - other.value, std::hypot(here.standardError, other.standardError)}};
  }
  shownResistance_ohm_ = done_.motor.resistance_ohm.value;
  setCurrentScale(done_.motor, options);
  done_.motor.gauge = onAnAxis(done_.motor.gauge);
  done_.remarks.push_back(done_.motor.gauge);
  return steps_.keep([this] {
    kept_.motor = done_.motor;
    kept_.expected_A = expected_A_;
    kept_.shownResistance_ohm = shownResistance_ohm_;
  });
}

/// The bridge's curve, where it has one, to the board.
void LinearJob::lineariseBoard() {
  const DutyCurve& curve = done_.motor.dutyCurve;
  if (!curve.known()) return;
  const auto taken = drive_.linearise(curve);
  linearised_ = taken.ok();
  done_.remarks.push_back(linearised_
                              ? "The bridge bends its duty: the board takes its voltages through the measured curve's "
                                "inverse."
                              : "The bridge bends its duty, and the board can't straighten it (" + taken.error().fact +
                                    "): breakaway ramps are made along a straight line.");
}

/// Careful gains, and how fast the axis may go between its ends: so that it speeds up with about what friction takes,
/// over less than a third of the travel.
Result<void> LinearJob::tune() {
  lineariseBoard();
  const IdentifiedMotor& motor = done_.motor;
  const double m = motor.inertia_kg_m2.value, Kf = forcePerAmpere(), Ke = motor.backEmfConstant_V_s_per_rad.value;
  const double tick_s = 1.0 / drive_.identity().loopRate_Hz, filter = boardVelocityBandwidth_rad_per_s(tick_s);
  ControllerSettings settings = drive_.settings();
  const double friction_A = std::max(0.01, motor.coulomb_Nm.value / motor.torqueConstant_Nm_per_A.value);
  const double spare_A = std::max(0.2 * friction_A, 0.5 * (settings.current_limit_A - friction_A));
  acceleration_m_per_s2_ = Kf * std::min(1.5 * friction_A, spare_A) / m;
  const double usable_V = drive_.identity().supply_V - motor.deadZone_V.value - 3.0 * shownResistance_ohm_ * friction_A;
  const double byTravel = std::sqrt(2.0 * acceleration_m_per_s2_ * 0.3 * travel_.usable_m());
  speed_m_per_s_ = std::min(byTravel, std::max(0.05 * drive_.identity().supply_V, 0.7 * usable_V) / Ke);
  const auto gains = tuneMotion(m, Kf, 0.15 * filter, 0.1 * filter);
  settings.velocity_kp_A_s_per_rad = gains.velocity_kp_A_s_per_rad;
  settings.velocity_ki_A_per_rad = gains.velocity_ki_A_per_rad;
  settings.velocity_kd_A_s2_per_rad = 0.0;
  settings.position_kp_A_per_rad = gains.position_kp_A_per_rad;
  settings.position_ki_A_per_rad_s = 0.0;
  settings.position_kd_A_s_per_rad = gains.position_kd_A_s_per_rad;
  settings.observer_cutoff_rad_per_s = tuneObserver(tick_s, filter);
  settings.nominal_inertia_kg_m2 = m;
  settings.nominal_torque_constant_Nm_per_A = Kf;
  settings.velocity_limit_rad_per_s = 0.3 * speed_m_per_s_;
  const auto accepted = drive_.configure(settings);
  if (!accepted) return accepted.error();
  done_.settings = *accepted;
  return {};
}

}  // namespace breakaway
