// The friction's chapter of a commissioning: homing, both sweeps, and the map.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "commission/commission_job.h"
#include "experiment/breakaway_sweep.h"
#include "experiment/homing.h"
#include "experiment/slow_turns.h"
#include "identify/map_estimation.h"
#include "identify/stribeck_velocity.h"
#include "identify/zero_track.h"

namespace breakaway {

namespace {

constexpr double longestTurn_runs = 5.0;  ///< of the velocity sweep, that a slow turn may take

}  // namespace

Result<void> CommissionJob::home() {
  HomingOptions options;
  options.countsPerRev = drive_.identity().countsPerRev;
  const auto homing = std::make_shared<Homing>(options);
  if (auto ran = steps_.run("04-homing", homing, 0.01); !ran) return ran;
  done_.indexAngle_rad = homing->indexAngle_rad();
  return {};
}

/// Long enough to bring the zero's noise to 0.3 % of the friction's current, within reason.
double CommissionJob::zeroing_s() const {
  const double friction_A = done_.motor.coulomb_Nm.value / done_.motor.torquePerShownAmpere_Nm();
  const double aim_A = 0.003 * std::max(1e-6, friction_A);
  return std::clamp(done_.noiseRms_A * done_.noiseRms_A / (aim_A * aim_A) / done_.identity.loopRate_Hz, 0.4, 4.0);
}

VelocityFrictionOptions CommissionJob::frictionOptions() const {
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

Result<void> CommissionJob::sweepVelocity() {
  const IdentifiedMotor& motor = done_.motor;
  const double friction_A = motor.coulomb_Nm.value / motor.torquePerShownAmpere_Nm();
  // Top speed from V = V0 + R·i + Ke·ω with friction's current and a third more, and 0.6 of it to leave room for
  // control.
  const double supply_V = drive_.identity().supply_V;
  const double lost_V =
      motor.dutyCurve.known() ? supply_V * (1.0 - motor.dutyCurve.output(1.0)) : motor.deadZone_V.value;
  const double perAmp_V = 1.33 * shownResistance_ohm_;
  const double slope_A = std::max(0.0, motor.viscous_Nm_s_per_rad.value) / motor.torquePerShownAmpere_Nm();
  const double usable_V = supply_V - lost_V - perAmp_V * friction_A;
  const double highest = std::max(1.0, 0.6 * usable_V / (motor.backEmfConstant_V_s_per_rad.value + perAmp_V * slope_A));
  VelocitySweepOptions options;
  // In an order in which speed and time have nothing to do with each other: a zero that drifts is no viscous friction.
  for (const double part : {0.2, 0.6, 0.1, 1.0, 0.05, 0.35}) options.speeds_rad_per_s.push_back(part * highest);
  options.indexAngle_rad = done_.indexAngle_rad.value;
  options.countsPerRev = done_.identity.countsPerRev;
  options.indexTolerance_rad = indexTolerance_rad(options.countsPerRev);
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

Result<void> CommissionJob::sweepBreakaway() {
  const IdentifiedMotor& motor = done_.motor;
  BreakawaySweepOptions options;
  options.bins = options_.bins;
  options.turns = options_.turns;
  options.indexAngle_rad = done_.indexAngle_rad.value;
  options.torqueConstant_Nm_per_A = motor.torquePerShownAmpere_Nm();
  const WindingLine line = rampLine();
  options.resistance_ohm = line.resistance_ohm.value;
  options.deadZone_V = line.deadZone_V.value;
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
  if (auto ran = steps_.run("06-breakaway-sweep", sweep, 0.658, gather); !ran) return ran;
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

/// What friction does between standing and moving. Where that can't be seen, a compensation goes without it.
Result<void> CommissionJob::turnSlowly() {
  SlowTurnsOptions options;
  // In a short job the slowest turn is a little faster.
  const double slowest = std::max(0.5, 2.0 * std::numbers::pi / (longestTurn_runs * options_.speedRun_s));
  options.speeds_rad_per_s = {4.0, 2.0, 1.0, std::min(slowest, 0.8)};
  options.zeroing_s = zeroing_s();
  const auto slow = std::make_shared<SlowTurns>(options);
  auto ran = steps_.run("07-slow-turns", slow, 0.04);
  if (slow->state() == Procedure::State::stopped) return ran;
  if (ran)
    done_.map.stribeckVelocity_rad_per_s =
        stribeckVelocity(slow->turns(), done_.map, done_.motor.torquePerShownAmpere_Nm());
  if (!(done_.map.stribeckVelocity_rad_per_s.value > 0.0))
    done_.remarks.push_back(
        "Slow turns don't show over which speed friction falls from static to Coulomb; compensation goes without "
        "static friction.");
  return {};
}

/// Once the breakaway torques are known, slow runs can be freed of what friction falls by with speed.
Result<void> CommissionJob::refitMoving(const std::vector<BreakawayEvent>& events, const MapOptions& options) {
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

}  // namespace breakaway
