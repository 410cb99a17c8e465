#include "friction_survey.h"

#include <cmath>
#include <cstdio>

#include "commission/travel_survey.h"

namespace breakaway {

namespace {

Estimate meanOfWays(const Estimate& one, const Estimate& other) {
  return {0.5 * (one.value + other.value), 0.5 * std::hypot(one.standardError, other.standardError)};
}

}  // namespace

std::optional<Estimate> FrictionSurvey::coulombAverage_Nm() const {
  if (!moving) return {};
  return meanOfWays((*moving)[0].coulombMean_Nm, (*moving)[1].coulombMean_Nm);
}

std::optional<Estimate> FrictionSurvey::viscousAverage_Nm_s_per_rad() const {
  if (!moving) return {};
  return meanOfWays((*moving)[0].viscousMean_Nm_s_per_rad, (*moving)[1].viscousMean_Nm_s_per_rad);
}

void FrictionSurvey::estimate() {
  moving.reset();
  map.reset();
  if (!identification) return;
  axis == Axis::linear ? estimateOverTravel() : estimateAroundRotor();
}

bool FrictionSurvey::sweepIsThere() {
  if (sweepComplete) return true;
  mapObstacle = events.empty() ? "no breakaway sweep was run" : "the breakaway sweep did not run to its end";
  return false;
}

MapOptions FrictionSurvey::mapOptions() const {
  MapOptions options;
  options.rig = rig;
  options.bins = bins;
  options.turns = turns;
  options.noiseRms_A = identification->noiseRms_A;
  return options;
}

void FrictionSurvey::estimateAroundRotor() {
  const double torqueConstant_Nm_per_A = identification->motor.torqueConstant_Nm_per_A.value;
  if (!runs.empty()) {
    VelocityFrictionOptions options;
    options.torqueConstant_Nm_per_A = torqueConstant_Nm_per_A;
    options.inertia_kg_m2 = identification->motor.inertia_kg_m2.value;
    options.bins = bins;
    if (auto fitted = fitMovingFriction(runs, options)) moving = std::move(*fitted);
  }
  if (!sweepIsThere()) return;
  MapOptions options = mapOptions();
  options.torqueConstant_Nm_per_A = torqueConstant_Nm_per_A;
  auto estimated = estimateMap(events, moving ? &*moving : nullptr, options);
  mapObstacle = estimated ? "" : estimated.error().message();
  if (!estimated) return;
  map = std::move(*estimated);
  map->settings = {{"torque_constant_Nm_per_A", torqueConstant_Nm_per_A},
                   {"resistance_ohm", identification->motor.resistance_ohm.value},
                   {"dead_zone_V", identification->motor.deadZone_V.value},
                   {"inertia_kg_m2", identification->motor.inertia_kg_m2.value},
                   {"missed", static_cast<double>(missed)}};
}

bool FrictionSurvey::layOver(const Travel& felt) {
  if (travel && sameEnds(*travel, felt)) return true;
  const bool nothing = events.empty() && strokes.empty();
  travel = felt;
  events.clear();
  strokes.clear();
  sweepComplete = false;
  strokeBins = missed = 0;
  moving.reset();
  map.reset();
  return nothing;
}

std::optional<KnownAxis> FrictionSurvey::knownAxis() const {
  if (!travel || !identification) return {};
  return KnownAxis{board, *travel, identification->motor, identification->shownResistance_ohm,
                   identification->noiseRms_A};
}

void FrictionSurvey::estimateOverTravel() {
  const auto known = knownAxis();
  if (!known || strokes.empty()) return;
  const TravelBins places{travel->first_m(), travel->last_m(), strokeBins};
  const TravelFrictionOptions friction = frictionOver(*known, places, strokesZeroError_A);
  auto fitted = fitTravelFriction(strokes, friction);
  mapObstacle = fitted ? "" : fitted.error().message();
  if (!fitted) return;
  moving = fitted->moving;
  if (sweepComplete && bins != strokeBins) {
    mapObstacle = "both sweeps were taken apart into different places";
    return;
  }
  if (!sweepIsThere()) return;
  MapOptions options = mapOptions();
  options.torqueConstant_Nm_per_A = known->forcePerAmpere();
  options.zeroError_A = eventsZeroError_A;
  options.totalVelocity_rad_per_s = travelTotalVelocity_m_per_s;
  auto survey = surveyTravel(events, strokes, *moving, friction, 0.0, options);
  mapObstacle = survey ? "" : survey.error().message();
  if (!survey) return;
  moving = survey->friction.moving;
  map = std::move(survey->map);
  map->settings = settings;
}

std::string breakawayTable(const std::vector<BreakawayEvent>& events, Axis axis) {
  std::string text = axis == Axis::linear ? "position_m,way,pass,bin,current_A,force_N,outlier\n"
                                          : "angle_rad,way,turn,bin,current_A,torque_Nm,outlier\n";
  for (const BreakawayEvent& event : events) {
    char line[160];
    std::snprintf(line, sizeof line, "%.9g,%s,%zu,%zu,%.9g,%.9g,%d\n", event.angle_rad,
                  event.way == Way::cw ? "cw" : "ccw", event.turn + 1, event.bin, event.current_A, event.torque_Nm,
                  event.outlier ? 1 : 0);
    text += line;
  }
  return text;
}

}  // namespace breakaway
