// The motor's chapter of a commissioning: winding, spin, reversal, tuning, and the scale of it all.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "commission/careful_tuning.h"
#include "commission/commission_job.h"
#include "experiment/current_zeroing.h"
#include "experiment/reversal_test.h"
#include "experiment/spin_test.h"
#include "experiment/winding_test.h"
#include "identify/reversal_inertia.h"
#include "identify/winding_fit.h"

namespace breakaway {

namespace {

constexpr double turnsToSpeed = 2.0;  // of a reversal, so that position torque averages out

double highestSpeed(const std::vector<SpinBlock>& blocks) {
  double highest = 0.0;
  for (size_t k = 1; k < blocks.size(); ++k) {
    highest = std::max(highest, std::abs(blocks[k].angle_rad - blocks[k - 1].angle_rad) / blocks[k].duration_s);
  }
  return highest;
}

}  // namespace

Result<void> CommissionJob::identify() {
  const auto zeroing = std::make_shared<CurrentZeroing>();
  if (auto ran = steps_.run("01-zero", zeroing, 0.002); !ran) return ran;
  done_.noiseRms_A = zeroing->noiseRms_A();
  done_.sensorZero_A = zeroing->zero_A();
  if (kept_.motor) {
    done_.motor = *kept_.motor;
    expected_A_ = kept_.expected_A;
    shownResistance_ohm_ = kept_.shownResistance_ohm;
    return {};
  }
  const auto winding = std::make_shared<WindingTest>();
  if (auto ran = steps_.run("02-winding", winding, 0.02); !ran) return ran;
  const auto fit = fitWinding(*winding);
  if (!fit) return Error{"02-winding", fit.error().message()};
  expected_A_ = fit->expected_A;
  SpinTestOptions spinOptions;
  // Where friction takes much of the supply, half of it would hardly turn the rotor.
  const double moving_V = fit->line.voltageFor(fit->friction_A()), supply_V = drive_.identity().supply_V;
  spinOptions.highest_V = std::clamp(2.5 * moving_V, 0.5 * supply_V, 0.9 * supply_V);
  auto spin = std::make_shared<SpinTest>(spinOptions);
  if (auto ran = steps_.run("03-spin", spin, 0.03); !ran) return ran;
  MotorIdentificationOptions options;
  options.trustedTorqueConstant_Nm_per_A = trustedTorqueConstant();
  auto motor = identifyMotor(spin->blocks(), fit->line, fit->timeConstant_s, options);
  if (!motor ||
      highestSpeed(spin->blocks()) * motor->backEmfConstant_V_s_per_rad.value < 0.3 * drive_.identity().supply_V) {
    // A heavy rotor doesn't come up to speed in so short a leg.
    spinOptions.leg_s *= 5.0;
    spinOptions.cycles = 2;
    spin = std::make_shared<SpinTest>(spinOptions);
    if (auto ran = steps_.run("03b-spin-slowly", spin, 0.0); !ran) return ran;
    motor = identifyMotor(spin->blocks(), fit->line, fit->timeConstant_s, options);
  }
  if (!motor) return Error{"03-spin", motor.error().message()};
  done_.motor = *motor;
  bridgeTests_.standing = winding->points();
  bridgeTests_.moving = {spin->blocks()};
  timeConstant_s_ = fit->timeConstant_s;
  bridgeTests_.timeConstant_s = fit->timeConstant_s.value;
  bridgeTests_.supply_V = drive_.identity().supply_V;
  const double Kt = motor->torqueConstant_Nm_per_A.value, Ke = motor->backEmfConstant_V_s_per_rad.value;
  if (std::abs(Kt - Ke) > 0.05 * Ke) {
    done_.remarks.push_back(
        "The trusted torque constant and the measured back-EMF constant differ by more than 5 %; in SI they are the "
        "same "
        "quantity. All torques rest on the trusted one.");
  }
  return {};
}

Result<void> CommissionJob::tune() {
  const auto accepted =
      drive_.configure(carefullyTuned(done_.motor.inertia_kg_m2.value, done_.motor.torqueConstant_Nm_per_A.value,
                                      1.0 / drive_.identity().loopRate_Hz, drive_.settings()));
  if (!accepted) return accepted.error();
  done_.settings = *accepted;
  return {};
}

/// The second way to the inertia. Where it can't be gone, the first stands alone, and a remark says so.
Result<void> CommissionJob::reverse() {
  if (kept_.motor) return {};
  const IdentifiedMotor& motor = done_.motor;
  const double Kt = motor.torqueConstant_Nm_per_A.value, J = motor.inertia_kg_m2.value;
  const double friction_A = std::max(0.01, motor.coulomb_Nm.value / Kt);
  const double most_A = 0.8 * done_.settings.current_limit_A, current_A = std::min(3.0 * friction_A, most_A);
  const double slope = Kt * current_A / J, free = drive_.identity().supply_V / motor.backEmfConstant_V_s_per_rad.value;
  ReversalTestOptions options;
  options.current_A = current_A;
  options.highest_rad_per_s =
      std::min(0.5 * free, std::max(0.2 * slope, std::sqrt(turnsToSpeed * 4.0 * std::numbers::pi * slope)));
  options.block_s = std::max(2.0 / drive_.identity().loopRate_Hz, options.highest_rad_per_s / slope / 40.0);
  const auto test = std::make_shared<ReversalTest>(options);
  auto ran = steps_.run("03c-reversal", test, 0.005);
  if (test->state() == Procedure::State::stopped) return ran;
  const auto inertia = ran ? reversalInertia(test->blocks(), {Kt, current_A}) : Result<Estimate>(ran.error());
  if (!inertia) {
    done_.remarks.push_back(inertia.error().message() + "; the inertia rests on the spin test alone.");
    return {};
  }
  bridgeTests_.moving.push_back(test->blocks());
  const double apart = joinInertia(done_.motor, *inertia);
  if (apart > 3.0) {
    done_.remarks.push_back(
        "The inertia by speeding up and slowing down and the one by turning round differ by more than three standard "
        "errors; the interval given covers both.");
  }
  return {};
}

/// Winding and bridge once more from all tests together, and the bridge's curve, where it has one, to the board.
void CommissionJob::fitWindings() {
  if (kept_.motor) {
    lineariseBoard();
    return;
  }
  const auto bridge = fitBridge(bridgeTests_);
  if (!bridge) {
    done_.remarks.push_back(bridge.error().message() +
                            "; resistance and back-EMF constant rest on a straight line beyond the dead zone.");
  } else {
    takeBridge(done_.motor, *bridge, timeConstant_s_);
  }
  lineariseBoard();
}

void CommissionJob::lineariseBoard() {
  const DutyCurve& curve = done_.motor.dutyCurve;
  if (!curve.known()) return;
  const auto taken = drive_.linearise(curve);
  linearised_ = taken.ok();
  done_.remarks.push_back(
      linearised_ ? "The bridge bends its duty: from the reversal test on the board takes its voltages through the "
                    "measured curve's inverse."
                  : "The bridge bends its duty, and the board can't straighten it (" + taken.error().fact +
                        "): breakaway ramps follow its tangent at the breakaway current.");
}

/// The line from command to current that breakaway ramps follow: what the board doesn't straighten, as a tangent.
WindingLine CommissionJob::rampLine() const {
  WindingLine line;
  line.resistance_ohm.value = shownResistance_ohm_;
  if (linearised_) return line;
  line.deadZone_V = done_.motor.deadZone_V;
  const DutyCurve& curve = done_.motor.dutyCurve;
  if (!curve.known()) return line;
  const double supply_V = drive_.identity().supply_V;
  const double near_A = std::max({expected_A_[0], expected_A_[1], 1e-3});
  const auto volts = [&](double current_A) {
    return supply_V * curve.input(shownResistance_ohm_ * current_A / supply_V);
  };
  line.resistance_ohm.value = (volts(1.2 * near_A) - volts(0.8 * near_A)) / (0.4 * near_A);
  line.deadZone_V.value = volts(near_A) - line.resistance_ohm.value * near_A;
  return line;
}

/// From here on torques are of true amperes, while the windings' voltage still follows the current as it is shown.
Result<void> CommissionJob::setScale() {
  if (kept_.motor) return {};
  CurrentScaleOptions options;
  if (options_.bench) {
    const Bench& bench = *options_.bench;
    if (bench.currentGainInterval) options.gainInterval = *bench.currentGainInterval;
    if (bench.trusted.contains("inertia_kg_m2")) options.trustedInertia_kg_m2 = bench.motor.inertia;
  }
  if (options_.against) {
    const Estimate &here = options_.addedInertia_kg_m2, &other = options_.against->addedInertia_kg_m2;
    options.added = AddedInertia{options_.against->motor.shownInertia_kg_m2,
                                 {here.value - other.value, std::hypot(here.standardError, other.standardError)}};
  }
  shownResistance_ohm_ = done_.motor.resistance_ohm.value;
  setCurrentScale(done_.motor, options);
  done_.remarks.push_back(done_.motor.gauge);
  return steps_.keep([this] {
    kept_.motor = done_.motor;
    kept_.expected_A = expected_A_;
    kept_.shownResistance_ohm = shownResistance_ohm_;
  });
}

}  // namespace breakaway
