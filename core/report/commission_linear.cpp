#include "report/commission_linear.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "experiment/compensation.h"
#include "experiment/travel_breakaway.h"
#include "experiment/travel_homing.h"
#include "experiment/travel_sweep.h"
#include "identify/travel_map.h"
#include "identify/zero_track.h"
#include "report/commission_begin.h"
#include "report/compensated_run.h"
#include "report/linear_job.h"
#include "report/measured_bench.h"

namespace breakaway {

namespace {

constexpr double totalVelocity_m_per_s = 0.1;
constexpr double sameTravel = 0.01;  // of the travel, by which a resumed job may find its ends elsewhere

}  // namespace

Result<void> LinearJob::home() {
  if (!drive_.identity().hasIndex) {
    done_.indexAngle_rad = {travel_.low_m, std::max(count_m(), 1e-5)};
    done_.remarks.emplace_back("The encoder has no index: positions are counted from the lower end.");
    return layBins();
  }
  TravelHomingOptions options;
  options.travel = travel_;
  options.searchSpeed_m_per_s = 0.2 * speed_m_per_s_;
  options.acceleration_m_per_s2 = acceleration_m_per_s2_;
  options.approachSpeed_m_per_s = 0.02 * speed_m_per_s_;
  options.count_m = count_m();
  options.backOff_m = std::max(0.002, 20.0 * count_m());
  const auto homing = std::make_shared<TravelHoming>(options);
  if (auto ran = steps_.run("05-homing", homing, 0.02); !ran) return ran;
  done_.indexAngle_rad = homing->index_m();
  return layBins();
}

/// Over the travel between the margins; a resumed job keeps the bins that it began with.
Result<void> LinearJob::layBins() {
  const double index_m = done_.indexAngle_rad.value;
  if (kept_.travel) {
    const Travel before{kept_.travel->low_m + index_m, kept_.travel->high_m + index_m, kept_.travel->margin_m};
    const double most_m = sameTravel * (before.high_m - before.low_m);
    if (std::abs(before.low_m - travel_.low_m) > most_m || std::abs(before.high_m - travel_.high_m) > most_m)
      return Error{"travel", "ends elsewhere than when the interrupted job was begun, expected the same axis"};
    travel_ = before;
  }
  kept_.travel = Travel{travel_.low_m - index_m, travel_.high_m - index_m, travel_.margin_m};
  bins_ = {travel_.first_m(), travel_.last_m(), options_.bins};
  return {};
}

/// Long enough to bring the zero's noise to 0.3 % of the friction's current, within reason.
double LinearJob::zeroing_s() const {
  const double friction_A = std::max(1e-6, done_.motor.coulomb_Nm.value / forcePerAmpere());
  const double aim_A = 0.003 * friction_A;
  return std::clamp(done_.noiseRms_A * done_.noiseRms_A / (aim_A * aim_A) / done_.identity.loopRate_Hz, 0.4, 4.0);
}

TravelFrictionOptions LinearJob::frictionOptions() const {
  TravelFrictionOptions options;
  options.forceConstant_N_per_A = forcePerAmpere();
  options.mass_kg = done_.motor.inertia_kg_m2.value;
  options.noiseRms_A = done_.noiseRms_A;
  options.zeroError_A = zeroError_A_;
  options.tick_s = 1.0 / done_.identity.loopRate_Hz;
  options.count_m = count_m();
  options.bins = bins_;
  return options;
}

Result<void> LinearJob::sweepVelocity() {
  TravelSweepOptions options;
  options.travel = travel_;
  options.bins = bins_;
  // In an order in which speed and time have nothing to do with each other; the slowest takes some of the usual time.
  const double slowest = std::max(0.012, travel_.usable_m() / (2.4 * options_.speedRun_s * speed_m_per_s_));
  for (const double part : {0.2, 0.7, 0.03, 1.0, 0.08, 0.012, 0.45}) {
    const double speed = std::max(part, slowest) * speed_m_per_s_;
    auto& speeds = options.speeds_m_per_s;
    if (std::find(speeds.begin(), speeds.end(), speed) == speeds.end()) speeds.push_back(speed);
  }
  options.acceleration_m_per_s2 = acceleration_m_per_s2_;
  options.run_s = options_.speedRun_s;
  options.zeroing_s = zeroing_s();
  options.index_m = done_.indexAngle_rad.value;
  options.indexTolerance_m = indexTolerance();
  const auto sweep = std::make_shared<TravelSweep>(options, kept_.strokes);
  // A zero is known from the zeroings of its own part alone.
  const size_t before = sweep->runs().size();
  const auto gather = [this, sweep, before] {
    kept_.strokes = sweep->runs();
    const auto fresh = kept_.strokes.begin() + static_cast<std::ptrdiff_t>(before);
    countFrom(ZeroTrack(sweep->zeros(), done_.noiseRms_A), std::span(fresh, kept_.strokes.end()));
  };
  if (auto ran = steps_.run("06-velocity-sweep", sweep, 0.25, gather); !ran) return ran;
  gather();
  done_.strokes = kept_.strokes;
  const ZeroTrack zeros(sweep->zeros(), done_.noiseRms_A);
  zeroError_A_ = zeros.at(done_.strokes[done_.strokes.size() / 2].middle_s).standardError;
  const auto friction = fitTravelFriction(done_.strokes, frictionOptions());
  if (!friction) return friction.error();
  return takeFriction(*friction);
}

Result<void> LinearJob::takeFriction(const TravelFriction& friction) {
  done_.moving = friction.moving;
  done_.map.stribeckVelocity_rad_per_s = friction.stribeck_m_per_s;
  if (friction.mass_kg.standardError > 0.0) joinMass(friction.mass_kg);
  return {};
}

/// Both ways to the mass weighted by their errors, which grow by as much as they disagree; the current's scale is in
/// both.
void LinearJob::joinMass(const Estimate& bySweep) {
  IdentifiedMotor& motor = done_.motor;
  const double gain = motor.currentGain.value, doubt = motor.currentGain.standardError / gain;
  const Estimate byStrokes{motor.shownInertia_kg_m2.value / gain, motor.shownInertia_kg_m2.standardError / gain};
  motor.reversalInertia_kg_m2 = {bySweep.value, std::hypot(bySweep.standardError, doubt * bySweep.value)};
  if (options_.bench && options_.bench->trusted.contains("mass_kg")) return;
  const double u = 1.0 / std::pow(byStrokes.standardError, 2), v = 1.0 / std::pow(bySweep.standardError, 2);
  const double apart =
      std::abs(byStrokes.value - bySweep.value) / std::hypot(byStrokes.standardError, bySweep.standardError);
  const double value = (u * byStrokes.value + v * bySweep.value) / (u + v);
  motor.inertia_kg_m2 = {value, std::hypot(std::max(1.0, apart) / std::sqrt(u + v), doubt * value)};
}

TravelBreakawayOptions LinearJob::breakawayOptions(const std::array<std::vector<double>, 2>& moving_A) const {
  const IdentifiedMotor& motor = done_.motor;
  TravelBreakawayOptions options;
  options.travel = travel_;
  options.bins = bins_;
  options.passes = options_.turns;
  options.forceConstant_N_per_A = forcePerAmpere();
  options.resistance_ohm = shownResistance_ohm_;
  options.deadZone_V = linearised_ ? 0.0 : motor.deadZone_V.value;
  options.mass_kg = motor.inertia_kg_m2.value;
  options.backEmfConstant_V_s_per_m = motor.backEmfConstant_V_s_per_rad.value;
  options.moving_A = moving_A;
  options.current_limit_A = done_.settings.current_limit_A;
  options.speed_m_per_s = 0.3 * speed_m_per_s_;
  options.acceleration_m_per_s2 = acceleration_m_per_s2_;
  options.count_m = count_m();
  options.motionVelocity_m_per_s = std::max(3e-4, 300.0 * count_m());
  options.zeroing_s = zeroing_s();
  options.zeroEvery_s = 20.0 * std::max(0.5, options.zeroing_s);
  options.index_m = done_.indexAngle_rad.value;
  options.indexTolerance_m = indexTolerance();
  return options;
}

Result<void> LinearJob::sweepBreakaway() {
  const auto moving_A = movingCurrent_A(done_.strokes);
  if (!moving_A) return moving_A.error();
  const TravelBreakawayOptions options = breakawayOptions(*moving_A);
  const double index_m = options.index_m;
  std::vector<BreakawayEvent> earlier = kept_.events;
  for (BreakawayEvent& event : earlier) event.angle_rad += index_m;
  const auto sweep = std::make_shared<TravelBreakaway>(options, earlier);
  const size_t before = sweep->events().size();
  const auto gather = [this, sweep, before, index_m] {
    kept_.events = sweep->events();
    for (BreakawayEvent& event : kept_.events) event.angle_rad -= index_m;
    const auto fresh = kept_.events.begin() + static_cast<std::ptrdiff_t>(before);
    countFrom(ZeroTrack(sweep->zeros(), done_.noiseRms_A), std::span(fresh, kept_.events.end()));
  };
  if (auto ran = steps_.run("07-breakaway-sweep", sweep, 0.6, gather); !ran) return ran;
  gather();
  done_.missed = sweep->missed();
  done_.zeroing_s = options.zeroing_s;
  done_.zeroings = sweep->zeros().size();
  if (done_.missed > 0)
    done_.remarks.push_back(std::to_string(done_.missed) +
                            " breakaways could not be measured; their bins rest on their neighbours.");
  const ZeroTrack zeros(sweep->zeros(), done_.noiseRms_A);
  const auto& kept = kept_.events;
  return drawMap(options, kept.empty() ? 0.0 : zeros.at(kept[kept.size() / 2].time_s).standardError);
}

/// Map and averages from all breakaways; `measured` is how they were.
Result<void> LinearJob::drawMap(const TravelBreakawayOptions& measured, double zeroError_A) {
  const double index_m = measured.index_m;
  MapOptions mapOptions;
  mapOptions.rig = options_.rig;
  mapOptions.bins = options_.bins;
  mapOptions.turns = options_.turns;
  mapOptions.torqueConstant_Nm_per_A = measured.forceConstant_N_per_A;
  mapOptions.noiseRms_A = done_.noiseRms_A;
  mapOptions.totalVelocity_rad_per_s = totalVelocity_m_per_s;
  std::vector<BreakawayEvent> events = kept_.events;
  for (BreakawayEvent& event : events) event.angle_rad += index_m;
  mapOptions.zeroError_A = zeroError_A;
  done_.events = calibrated(events, mapOptions);
  // Once the breakaway forces are known, slow strokes can be freed of what friction falls by with speed.
  const auto still = estimateTravelMap(events, done_.moving, bins_, index_m, mapOptions);
  if (!still) return still.error();
  TravelFrictionOptions again = frictionOptions();
  for (const MapBin& bin : still->bins) {
    for (size_t w = 0; w < 2; ++w) again.static_N[w].push_back(bin.way[w].static_Nm.value);
  }
  const auto friction = fitTravelFriction(done_.strokes, again);
  if (!friction) return friction.error();
  if (auto taken = takeFriction(*friction); !taken) return taken;
  auto map = estimateTravelMap(events, done_.moving, bins_, index_m, mapOptions);
  if (!map) return map.error();
  done_.map = std::move(*map);
  done_.map.stribeckVelocity_rad_per_s = friction->stribeck_m_per_s;
  if (!(friction->stribeck_m_per_s.value > 0.0))
    done_.remarks.emplace_back(
        "Slow strokes don't show over which speed friction falls from static to Coulomb; compensation goes without "
        "static friction.");
  const double doubt = done_.motor.currentGain.standardError / done_.motor.currentGain.value;
  done_.motor.coulomb_Nm = done_.map.coulombAverage_Nm;
  done_.motor.viscous_Nm_s_per_rad = done_.map.viscousAverage_Nm_s_per_rad;
  for (Estimate* one : {&done_.motor.coulomb_Nm, &done_.motor.viscous_Nm_s_per_rad})
    one->standardError = std::hypot(one->standardError, doubt * one->value);
  noteSettings(measured);
  return {};
}

void LinearJob::noteSettings(const TravelBreakawayOptions& measured) {
  done_.map.settings = {{"force_constant_N_per_A", measured.forceConstant_N_per_A},
                        {"resistance_ohm", measured.resistance_ohm},
                        {"dead_zone_V", measured.deadZone_V},
                        {"mass_kg", measured.mass_kg},
                        {"dwell_s", measured.dwell_s},
                        {"settle_s", measured.settle_s},
                        {"ramp_s", measured.ramp_s},
                        {"motion_velocity_m_per_s", measured.motionVelocity_m_per_s},
                        {"motion_counts", static_cast<double>(measured.motionCounts)},
                        {"travel_m", travel_.high_m - travel_.low_m},
                        {"margin_m", travel_.margin_m},
                        {"highest_speed_m_per_s", speed_m_per_s_},
                        {"missed", static_cast<double>(done_.missed)}};
}

Result<void> LinearJob::compensate() {
  CompensatedRunOptions options;
  const double reach_m = 0.25 * travel_.usable_m();
  options.amplitude_rad_per_s = std::min(0.1 * speed_m_per_s_, 6.283185307179586 * reach_m / options.period_s);
  options.start_rad = travel_.middle_m() - 0.5 * options.amplitude_rad_per_s * options.period_s / 3.141592653589793;
  return runCompensated(drive_, steps_, done_, options);
}

void LinearJob::fillBench() {
  done_.bench = measuredBench(done_, options_, shownResistance_ohm_);
}

Result<Commission> LinearJob::run() {
  done_.identity = drive_.identity();
  done_.addedInertia_kg_m2 = options_.addedInertia_kg_m2;
  if (!(done_.identity.countsPerRev > 0.0)) return Error{"board", "has no encoder, which everything here rests on"};
  if (options_.against && options_.against->addedInertia_kg_m2.value == options_.addedInertia_kg_m2.value)
    return Error{"added mass", "is the same as in the motor's file that it is held against, expected another one"};
  static_cast<void>(drive_.linearise({}));  // an earlier job's curve; a board that takes none has none
  if (const auto ok = beginProgress(options_, done_, kept_); !ok) return ok.error();
  if (const auto ok = zero(); !ok) return ok.error();
  if (const auto ok = findEnds(); !ok) return ok.error();
  if (const auto ok = identify(); !ok) return ok.error();
  if (options_.motorOnly) {
    drive_.stop("the motor is identified");
    fillBench();
    return std::move(done_);
  }
  if (const auto ok = tune(); !ok) return ok.error();
  if (const auto ok = home(); !ok) return ok.error();
  if (const auto ok = sweepVelocity(); !ok) return ok.error();
  if (const auto ok = sweepBreakaway(); !ok) return ok.error();
  fillBench();
  if (const auto ok = compensate(); !ok) return ok.error();
  drive_.stop("the job is done");
  return std::move(done_);
}

Result<Commission> commissionLinear(Drive& drive, const CommissionOptions& options) {
  return LinearJob(drive, options).run();
}

}  // namespace breakaway
