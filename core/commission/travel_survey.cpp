#include "commission/travel_survey.h"

#include <algorithm>
#include <cmath>

#include "commission/travel_plan.h"
#include "identify/travel_map.h"

namespace breakaway {

namespace {

void joinMass(const Estimate& bySweep, bool trusted, IdentifiedMotor& motor) {
  const double gain = motor.currentGain.value, doubt = motor.currentGain.standardError / gain;
  const Estimate byStrokes{motor.shownInertia_kg_m2.value / gain, motor.shownInertia_kg_m2.standardError / gain};
  motor.reversalInertia_kg_m2 = {bySweep.value, std::hypot(bySweep.standardError, doubt * bySweep.value)};
  if (trusted) return;
  const double u = 1.0 / std::pow(byStrokes.standardError, 2), v = 1.0 / std::pow(bySweep.standardError, 2);
  const double apart =
      std::abs(byStrokes.value - bySweep.value) / std::hypot(byStrokes.standardError, bySweep.standardError);
  const double value = (u * byStrokes.value + v * bySweep.value) / (u + v);
  motor.inertia_kg_m2 = {value, std::hypot(std::max(1.0, apart) / std::sqrt(u + v), doubt * value)};
}

}  // namespace

Result<TravelSurvey> surveyTravel(const Commission& axis, const MapOptions& options) {
  const double index_m = axis.indexAngle_rad.value;
  std::vector<BreakawayEvent> events = axis.breakaways;
  for (BreakawayEvent& event : events) event.angle_rad += index_m;
  TravelFrictionOptions friction = frictionOver(axis);
  const auto still = estimateTravelMap(events, axis.moving, friction.bins, index_m, options);
  if (!still) return still.error();
  for (const MapBin& bin : still->bins) {
    for (size_t w = 0; w < 2; ++w) friction.static_N[w].push_back(bin.way[w].static_Nm.value);
  }
  auto fitted = fitTravelFriction(axis.strokes, friction);
  if (!fitted) return fitted.error();
  auto map = estimateTravelMap(events, fitted->moving, friction.bins, index_m, options);
  if (!map) return map.error();
  map->stribeckVelocity_rad_per_s = fitted->stribeck_m_per_s;
  return TravelSurvey{std::move(*fitted), std::move(*map)};
}

void takeTravelFriction(const TravelFriction& friction, const std::optional<Bench>& bench, Commission& axis) {
  axis.moving = friction.moving;
  if (friction.mass_kg.standardError > 0.0)
    joinMass(friction.mass_kg, bench && bench->trusted.contains("mass_kg"), axis.motor);
}

}  // namespace breakaway
