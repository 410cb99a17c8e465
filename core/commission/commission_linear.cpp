#include "commission/commission_linear.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "commission/commission_begin.h"
#include "commission/compensated_run.h"
#include "commission/final_tuning.h"
#include "commission/linear_job.h"
#include "commission/measured_bench.h"
#include "commission/travel_survey.h"
#include "experiment/compensation.h"
#include "identify/zero_track.h"

namespace breakaway {

Result<void> LinearJob::home() {
  if (!drive_.identity().hasIndex) {
    done_.indexAngle_rad = lowerEnd(known());
    done_.remarks.emplace_back("The encoder has no index: positions are counted from the lower end.");
    return layBins();
  }
  const auto homing = std::make_shared<TravelHoming>(homingOver(known(), pace_));
  if (auto ran = steps_.run("05-homing", homing, 0.02); !ran) return ran;
  done_.indexAngle_rad = homing->index_m();
  return layBins();
}

/// Over the travel between the margins; a resumed job keeps the bins that it began with.
Result<void> LinearJob::layBins() {
  const double index_m = done_.indexAngle_rad.value;
  if (kept_.travel) {
    const Travel before = moved(*kept_.travel, index_m);
    if (!sameEnds(before, travel_))
      return Error{"travel", "ends elsewhere than when the interrupted job was begun, expected the same axis"};
    travel_ = before;
  }
  kept_.travel = moved(travel_, -index_m);
  bins_ = {travel_.first_m(), travel_.last_m(), options_.bins};
  return {};
}

Result<void> LinearJob::sweepVelocity() {
  // In an order in which speed and time have nothing to do with each other.
  constexpr double parts[] = {0.2, 0.7, 0.03, 1.0, 0.08, 0.012, 0.45};
  const auto sweep = std::make_shared<TravelSweep>(velocitySweepOver(known(), pace_, bins_, parts, options_.speedRun_s),
                                                   kept_.strokes);
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
  const auto friction = fitTravelFriction(done_.strokes, frictionOver(known(), bins_, zeroError_A_));
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

Result<void> LinearJob::sweepBreakaway() {
  const auto moving_A = movingCurrent_A(done_.strokes);
  if (!moving_A) return moving_A.error();
  const TravelBreakawayOptions options = breakawaySweepOver(known(), pace_, bins_, options_.turns, *moving_A);
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
  mapOptions.totalVelocity_rad_per_s = travelTotalVelocity_m_per_s;
  std::vector<BreakawayEvent> events = kept_.events;
  for (BreakawayEvent& event : events) event.angle_rad += index_m;
  mapOptions.zeroError_A = zeroError_A;
  done_.events = calibrated(events, mapOptions);
  auto survey = surveyTravel(events, done_.strokes, done_.moving, frictionOver(known(), bins_, zeroError_A_), index_m,
                             mapOptions);
  if (!survey) return survey.error();
  if (auto taken = takeFriction(survey->friction); !taken) return taken;
  done_.map = std::move(survey->map);
  if (!(survey->friction.stribeck_m_per_s.value > 0.0))
    done_.remarks.emplace_back(
        "Slow strokes don't show over which speed friction falls from static to Coulomb; compensation goes without "
        "static friction.");
  const double doubt = done_.motor.currentGain.standardError / done_.motor.currentGain.value;
  done_.motor.coulomb_Nm = done_.map.coulombAverage_Nm;
  done_.motor.viscous_Nm_s_per_rad = done_.map.viscousAverage_Nm_s_per_rad;
  for (Estimate* one : {&done_.motor.coulomb_Nm, &done_.motor.viscous_Nm_s_per_rad})
    one->standardError = std::hypot(one->standardError, doubt * one->value);
  done_.map.settings = settingsOf(measured, pace_, done_.missed);
  return {};
}

Result<void> LinearJob::compensate() {
  CompensatedRunOptions options;
  const double reach_m = 0.25 * travel_.usable_m();
  options.amplitude_rad_per_s = std::min(0.1 * pace_.speed_m_per_s, 6.283185307179586 * reach_m / options.period_s);
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
  tuneForUse(drive_, done_);
  if (const auto ok = compensate(); !ok) return ok.error();
  drive_.stop("the job is done");
  return std::move(done_);
}

Result<Commission> commissionLinear(Drive& drive, const CommissionOptions& options) {
  return LinearJob(drive, options).run();
}

}  // namespace breakaway
