#include "report/commission.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "control/tuning.h"
#include "experiment/breakaway_sweep.h"
#include "experiment/current_zeroing.h"
#include "experiment/homing.h"
#include "experiment/reversal_test.h"
#include "experiment/spin_test.h"
#include "experiment/winding_test.h"
#include "identify/map_estimation.h"
#include "identify/reversal_inertia.h"
#include "identify/zero_track.h"
#include "report/commission_steps.h"

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

/// The job's state while it runs.
class Job {
 public:
  Job(Drive& drive, const CommissionOptions& options)
      : drive_(drive), options_(options), steps_(drive, options, done_, kept_) {}
  Result<Commission> run();

 private:
  std::optional<double> trustedTorqueConstant() const;
  Result<void> begin();
  Result<void> identify();
  Result<void> tune();
  Result<void> reverse();
  Result<void> setScale();
  Result<void> home();
  Result<void> sweepVelocity();
  Result<void> sweepBreakaway();
  Result<void> refitMoving(const std::vector<BreakawayEvent>& events, const MapOptions& options);
  void fillBench();
  VelocityFrictionOptions frictionOptions() const;
  double zeroing_s() const;

  Drive& drive_;
  const CommissionOptions& options_;
  Commission done_;
  std::array<double, 2> expected_A_{0.0, 0.0};
  CommissionProgress kept_;
  CommissionSteps steps_;
  double shownResistance_ohm_ = 0.0;  ///< with the current as the sensor shows it
  double zeroError_A_ = 0.0;          ///< over the velocity sweep
};

std::optional<double> Job::trustedTorqueConstant() const {
  if (!options_.bench || !options_.bench->trusted.contains("torque_constant_Nm_per_A")) return {};
  return options_.bench->motor.torqueConstant;
}

/// Fresh, or from what was kept, if that belongs to this job.
Result<void> Job::begin() {
  CommissionProgress fresh;
  fresh.device = done_.identity.device;
  fresh.bins = options_.bins;
  fresh.turns = options_.turns;
  fresh.speedRun_s = options_.speedRun_s;
  fresh.trustedTorqueConstant_Nm_per_A = trustedTorqueConstant();
  kept_ = options_.earlier.value_or(fresh);
  if (!options_.earlier) return {};
  if (kept_.device != fresh.device)
    return Error{"board", "is " + fresh.device + ", but the interrupted job was begun on " + kept_.device};
  if (kept_.bins != fresh.bins || kept_.turns != fresh.turns) {
    return Error{"bins and turns", "are " + std::to_string(fresh.bins) + " and " + std::to_string(fresh.turns) +
                                       ", but the interrupted job was begun with " + std::to_string(kept_.bins) +
                                       " and " + std::to_string(kept_.turns)};
  }
  if (kept_.speedRun_s != fresh.speedRun_s)
    return Error{"seconds at each speed", "are others than the interrupted job was begun with, expected the same"};
  if (kept_.trustedTorqueConstant_Nm_per_A != fresh.trustedTorqueConstant_Nm_per_A)
    return Error{
        "bench",
        "trusts another torque constant than the interrupted job was begun with, expected the same bench file"};
  ++kept_.part;
  done_.rigTime_s = kept_.rigTime_s;
  done_.remarks = kept_.remarks;
  done_.remarks.push_back("The job was interrupted and went on: part " + std::to_string(kept_.part) + " began after " +
                          std::to_string(kept_.runs.size()) + " runs and " + std::to_string(kept_.events.size()) +
                          " breakaways.");
  return {};
}

Result<void> Job::identify() {
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
  const auto line = fitWindingLine(winding->points());
  if (!line) return Error{"02-winding", line.error().message()};
  const auto constant = fitTimeConstant(winding->squareResponse_A(), winding->squareTick_s());
  if (!constant) return Error{"02-winding", constant.error().message()};
  for (size_t way = 0; way < 2; ++way) {
    for (const double one : winding->breakaway_A()[way]) expected_A_[way] = std::max(expected_A_[way], one);
  }
  SpinTestOptions spinOptions;
  auto spin = std::make_shared<SpinTest>(spinOptions);
  if (auto ran = steps_.run("03-spin", spin, 0.03); !ran) return ran;
  MotorIdentificationOptions options;
  options.trustedTorqueConstant_Nm_per_A = trustedTorqueConstant();
  auto motor = identifyMotor(spin->blocks(), *line, *constant, options);
  if (!motor ||
      highestSpeed(spin->blocks()) * motor->backEmfConstant_V_s_per_rad.value < 0.3 * drive_.identity().supply_V) {
    // A heavy rotor doesn't come up to speed in so short a leg.
    spinOptions.leg_s *= 5.0;
    spinOptions.cycles = 2;
    spin = std::make_shared<SpinTest>(spinOptions);
    if (auto ran = steps_.run("03b-spin-slowly", spin, 0.0); !ran) return ran;
    motor = identifyMotor(spin->blocks(), *line, *constant, options);
  }
  if (!motor) return Error{"03-spin", motor.error().message()};
  done_.motor = *motor;
  const double Kt = motor->torqueConstant_Nm_per_A.value, Ke = motor->backEmfConstant_V_s_per_rad.value;
  if (std::abs(Kt - Ke) > 0.05 * Ke) {
    done_.remarks.push_back(
        "The trusted torque constant and the measured back-EMF constant differ by more than 5 %; in SI they are the "
        "same "
        "quantity. All torques rest on the trusted one.");
  }
  return {};
}

Result<void> Job::tune() {
  const double J = done_.motor.inertia_kg_m2.value, Kt = done_.motor.torqueConstant_Nm_per_A.value;
  const double tick_s = 1.0 / drive_.identity().loopRate_Hz;
  const double filter = boardVelocityBandwidth_rad_per_s(tick_s);
  const auto gains = tuneMotion(J, Kt, 0.15 * filter, 0.1 * filter);
  ControllerSettings settings = drive_.settings();
  settings.velocity_kp_A_s_per_rad = gains.velocity_kp_A_s_per_rad;
  settings.velocity_ki_A_per_rad = gains.velocity_ki_A_per_rad;
  settings.velocity_kd_A_s2_per_rad = 0.0;
  settings.position_kp_A_per_rad = gains.position_kp_A_per_rad;
  settings.position_ki_A_per_rad_s = 0.0;
  settings.position_kd_A_s_per_rad = gains.position_kd_A_s_per_rad;
  settings.observer_cutoff_rad_per_s = tuneObserver(tick_s, filter);
  settings.nominal_inertia_kg_m2 = J;
  settings.nominal_torque_constant_Nm_per_A = Kt;
  const auto accepted = drive_.configure(settings);
  if (!accepted) return accepted.error();
  done_.settings = *accepted;
  return {};
}

/// The second way to the inertia. Where it can't be gone, the first stands alone, and a remark says so.
Result<void> Job::reverse() {
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
  const double apart = joinInertia(done_.motor, *inertia);
  if (apart > 3.0) {
    done_.remarks.push_back(
        "The inertia by speeding up and slowing down and the one by turning round differ by more than three standard "
        "errors; the interval given covers both.");
  }
  return {};
}

/// From here on torques are of true amperes, while the windings' voltage still follows the current as it is shown.
Result<void> Job::setScale() {
  if (kept_.motor) return {};
  CurrentScaleOptions options;
  if (options_.bench) {
    const Bench& bench = *options_.bench;
    if (bench.currentGainInterval) options.gainInterval = *bench.currentGainInterval;
    if (bench.trusted.contains("inertia_kg_m2")) options.trustedInertia_kg_m2 = bench.motor.inertia;
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

Result<void> Job::home() {
  HomingOptions options;
  options.countsPerRev = drive_.identity().countsPerRev;
  const auto homing = std::make_shared<Homing>(options);
  if (auto ran = steps_.run("04-homing", homing, 0.01); !ran) return ran;
  done_.indexAngle_rad = homing->indexAngle_rad();
  return {};
}

/// Long enough to bring the zero's noise to 0.3 % of the friction's current, within reason.
double Job::zeroing_s() const {
  const double friction_A = done_.motor.coulomb_Nm.value / done_.motor.torquePerShownAmpere_Nm();
  const double aim_A = 0.003 * std::max(1e-6, friction_A);
  return std::clamp(done_.noiseRms_A * done_.noiseRms_A / (aim_A * aim_A) / done_.identity.loopRate_Hz, 0.4, 4.0);
}

VelocityFrictionOptions Job::frictionOptions() const {
  VelocityFrictionOptions options;
  options.torqueConstant_Nm_per_A = done_.motor.torquePerShownAmpere_Nm();
  options.inertia_kg_m2 = done_.motor.inertia_kg_m2.value;
  const Estimate& Kt = done_.motor.torqueConstant_Nm_per_A;
  options.scaleError = Kt.value > 0.0 ? Kt.standardError / Kt.value : 0.0;
  options.noiseRms_A = done_.noiseRms_A;
  options.zeroError_A = zeroError_A_;
  options.bins = options_.bins;
  return options;
}

Result<void> Job::sweepVelocity() {
  const IdentifiedMotor& motor = done_.motor;
  const double friction_A = motor.coulomb_Nm.value / motor.torquePerShownAmpere_Nm();
  // Top speed from V = V0 + R·i + Ke·ω with friction's current and a third more, and 0.6 of it to leave room for
  // control.
  const double perAmp_V = 1.33 * shownResistance_ohm_;
  const double slope_A = std::max(0.0, motor.viscous_Nm_s_per_rad.value) / motor.torquePerShownAmpere_Nm();
  const double usable_V = drive_.identity().supply_V - motor.deadZone_V.value - perAmp_V * friction_A;
  const double highest = std::max(1.0, 0.6 * usable_V / (motor.backEmfConstant_V_s_per_rad.value + perAmp_V * slope_A));
  VelocitySweepOptions options;
  // In an order in which speed and time have nothing to do with each other: a zero that drifts is no viscous friction.
  for (const double part : {0.2, 0.6, 0.1, 1.0, 0.05, 0.35}) options.speeds_rad_per_s.push_back(part * highest);
  options.indexAngle_rad = done_.indexAngle_rad.value;
  options.indexTolerance_rad = indexTolerance_rad(done_.identity.countsPerRev);
  options.run_s = options_.speedRun_s;
  options.zeroing_s = zeroing_s();
  const auto sweep = std::make_shared<VelocitySweep>(options, kept_.runs);
  // A zero is known from the zeroings of its own part alone.
  const size_t before = sweep->runs().size();
  const auto gather = [this, sweep, before] {
    kept_.runs = sweep->runs();
    std::vector<VelocityRun> fresh(kept_.runs.begin() + static_cast<std::ptrdiff_t>(before), kept_.runs.end());
    countFrom(ZeroTrack(sweep->zeros(), done_.noiseRms_A), fresh);
    std::move(fresh.begin(), fresh.end(), kept_.runs.begin() + static_cast<std::ptrdiff_t>(before));
  };
  if (auto ran = steps_.run("05-velocity-sweep", sweep, 0.2, gather); !ran) return ran;
  done_.runs = kept_.runs;
  const ZeroTrack zeros(sweep->zeros(), done_.noiseRms_A);
  if (!done_.runs.empty()) zeroError_A_ = zeros.at(done_.runs[done_.runs.size() / 2].middle_s).standardError;
  auto moving = fitMovingFriction(done_.runs, frictionOptions());
  if (!moving) return moving.error();
  done_.moving = std::move(*moving);
  return {};
}

Result<void> Job::sweepBreakaway() {
  const IdentifiedMotor& motor = done_.motor;
  BreakawaySweepOptions options;
  options.bins = options_.bins;
  options.turns = options_.turns;
  options.indexAngle_rad = done_.indexAngle_rad.value;
  options.torqueConstant_Nm_per_A = motor.torquePerShownAmpere_Nm();
  options.resistance_ohm = shownResistance_ohm_;
  options.deadZone_V = motor.deadZone_V.value;
  options.inertia_kg_m2 = motor.inertia_kg_m2.value;
  options.backEmfConstant_V_s_per_rad = motor.backEmfConstant_V_s_per_rad.value;
  options.expected_A = expected_A_;
  for (const Way way : {Way::cw, Way::ccw})
    options.moving_A[static_cast<size_t>(way)] = movingCurrent_A(done_.runs, way, frictionOptions());
  options.countsPerRev = drive_.identity().countsPerRev;
  options.zeroing_s = zeroing_s();
  options.indexTolerance_rad = indexTolerance_rad(options.countsPerRev);
  options.zeroEvery_s = 20.0 * std::max(0.5, options.zeroing_s);
  options.current_limit_A = done_.settings.current_limit_A;
  const auto sweep = std::make_shared<BreakawaySweep>(options, kept_.events);
  const size_t before = sweep->events().size();
  const auto gather = [this, sweep, before] {
    kept_.events = sweep->events();
    std::vector<BreakawayEvent> fresh(kept_.events.begin() + static_cast<std::ptrdiff_t>(before), kept_.events.end());
    countFrom(ZeroTrack(sweep->zeros(), done_.noiseRms_A), fresh);
    std::move(fresh.begin(), fresh.end(), kept_.events.begin() + static_cast<std::ptrdiff_t>(before));
  };
  if (auto ran = steps_.run("06-breakaway-sweep", sweep, 0.738, gather); !ran) return ran;
  const std::vector<BreakawayEvent>& events = kept_.events;
  const ZeroTrack zeros(sweep->zeros(), done_.noiseRms_A);
  done_.missed = sweep->missed();
  done_.zeroing_s = options.zeroing_s;
  done_.zeroings = sweep->zeros().size();
  if (done_.missed > 0)
    done_.remarks.push_back(std::to_string(done_.missed) +
                            " breakaways could not be measured; their bins rest on their neighbours.");
  MapOptions mapOptions;
  mapOptions.rig = options_.rig;
  mapOptions.bins = options_.bins;
  mapOptions.turns = options_.turns;
  mapOptions.torqueConstant_Nm_per_A = options.torqueConstant_Nm_per_A;
  mapOptions.noiseRms_A = done_.noiseRms_A;
  if (!events.empty()) mapOptions.zeroError_A = zeros.at(events[events.size() / 2].time_s).standardError;
  done_.events = calibrated(events, mapOptions);
  if (auto refitted = refitMoving(events, mapOptions); !refitted) return refitted;
  auto map = estimateMap(events, &done_.moving, mapOptions);
  if (!map) return map.error();
  done_.map = std::move(*map);
  const double doubt = done_.motor.currentGain.standardError / done_.motor.currentGain.value;
  done_.motor.coulomb_Nm = done_.map.coulombAverage_Nm;
  done_.motor.viscous_Nm_s_per_rad = done_.map.viscousAverage_Nm_s_per_rad;
  for (Estimate* one : {&done_.motor.coulomb_Nm, &done_.motor.viscous_Nm_s_per_rad})
    one->standardError = std::hypot(one->standardError, doubt * one->value);
  done_.map.settings = {{"torque_constant_Nm_per_A", options.torqueConstant_Nm_per_A},
                        {"resistance_ohm", options.resistance_ohm},
                        {"dead_zone_V", options.deadZone_V},
                        {"inertia_kg_m2", options.inertia_kg_m2},
                        {"dwell_s", options.dwell_s},
                        {"settle_s", options.settle_s},
                        {"ramp_s", options.ramp_s},
                        {"motion_velocity_rad_per_s", options.motionVelocity_rad_per_s},
                        {"motion_counts", static_cast<double>(options.motionCounts)},
                        {"index_angle_rad", options.indexAngle_rad},
                        {"missed", static_cast<double>(done_.missed)}};
  return {};
}

/// Once the breakaway torques are known, slow runs can be freed of what friction falls by with speed.
Result<void> Job::refitMoving(const std::vector<BreakawayEvent>& events, const MapOptions& options) {
  const auto still = estimateMap(events, nullptr, options);
  if (!still) return still.error();
  VelocityFrictionOptions friction = frictionOptions();
  for (const MapBin& bin : still->bins) {
    for (size_t w = 0; w < 2; ++w) friction.static_Nm[w].push_back(bin.way[w].static_Nm.value);
  }
  auto moving = fitMovingFriction(done_.runs, friction);
  if (!moving) return moving.error();
  done_.moving = std::move(*moving);
  const size_t slow = std::max(done_.moving[0].leftOut, done_.moving[1].leftOut);
  if (slow > 0) {
    done_.remarks.push_back(
        "At the slowest " + std::to_string(slow) +
        " speeds friction still falls with speed; what it has to fall from the breakaway torque was "
        "taken off before Coulomb and viscous friction were fitted.");
  }
  return {};
}

void Job::fillBench() {
  const IdentifiedMotor& motor = done_.motor;
  Bench& bench = done_.bench;
  if (options_.bench) bench = *options_.bench;
  if (bench.name.empty()) bench.name = options_.rig;
  bench.axis = Axis::rotary;
  bench.input = DriveInput::current;
  bench.supply_V = drive_.identity().supply_V;
  bench.countsPerUnit = drive_.identity().countsPerRev;
  // Recordings show the current as the sensor does; with it go torque constant and winding.
  bench.motor.torqueConstant = motor.torquePerShownAmpere_Nm();
  bench.motor.backEmfConstant = motor.backEmfConstant_V_s_per_rad.value;
  bench.motor.resistance_ohm = shownResistance_ohm_;
  if (motor.inductance_H.value > 0.0) bench.motor.inductance_H = motor.inductance_H.value / motor.currentGain.value;
  bench.motor.inertia = motor.inertia_kg_m2.value;
  bench.motor.viscous = std::max(0.0, done_.map.viscousAverage_Nm_s_per_rad.value);
  bench.motor.coulomb = std::max(0.0, done_.map.coulombAverage_Nm.value);
  bench.trusted.insert("torque_constant_Nm_per_A");
  bench.controller = {ControlMode::velocity,
                      done_.settings.velocity_kp_A_s_per_rad,
                      done_.settings.velocity_ki_A_per_rad,
                      done_.settings.velocity_kd_A_s2_per_rad,
                      done_.settings.observer_cutoff_rad_per_s,
                      done_.settings.nominal_inertia_kg_m2,
                      done_.settings.nominal_torque_constant_Nm_per_A,
                      done_.settings.current_limit_A};
}

Result<Commission> Job::run() {
  done_.identity = drive_.identity();
  if (!(done_.identity.countsPerRev > 0.0)) return Error{"board", "has no encoder, which everything here rests on"};
  if (!done_.identity.hasIndex) return Error{"board", "has an encoder without index, which homing needs"};
  if (const auto ok = begin(); !ok) return ok.error();
  if (const auto ok = identify(); !ok) return ok.error();
  if (const auto ok = tune(); !ok) return ok.error();
  if (const auto ok = reverse(); !ok) return ok.error();
  if (const auto ok = setScale(); !ok) return ok.error();
  if (const auto ok = home(); !ok) return ok.error();
  if (const auto ok = sweepVelocity(); !ok) return ok.error();
  if (const auto ok = sweepBreakaway(); !ok) return ok.error();
  drive_.stop("the job is done");
  fillBench();
  return std::move(done_);
}

}  // namespace

Result<Commission> commission(Drive& drive, const CommissionOptions& options) {
  auto result = Job(drive, options).run();
  if (!result) drive.stop(result.error().message());
  return result;
}

}  // namespace breakaway
