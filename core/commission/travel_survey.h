// All that both sweeps say of a linear axis' friction, put together.
#pragma once

#include <optional>

#include "base/result.h"
#include "commission/known.h"
#include "friction/friction_map.h"
#include "identify/map_estimation.h"
#include "identify/travel_friction.h"

namespace breakaway {

/// At which a travel's map gives the total force.
inline constexpr double travelTotalVelocity_m_per_s = 0.1;

struct TravelSurvey {
  TravelFriction friction;  ///< slow strokes freed of what friction falls by with speed
  FrictionMap map;          ///< with the Stribeck speed, where slow strokes show it
};

/// Once the breakaway forces are known, slow strokes can be freed of what friction falls by with speed, and the map is
/// drawn upon what is left. `axis` must have strokes, breakaways and the moving friction by fitTravelFriction() without
/// them. Errors: those of estimateTravelMap() and fitTravelFriction().
Result<TravelSurvey> surveyTravel(const Commission& axis, const MapOptions& options);

/// The moving friction becomes the axis', and the mass by strokes at several speeds is joined with that by strokes by
/// voltage, unless the bench trusts one: both weighted by their errors, which grow by as much as they disagree; the
/// current's scale is in both.
void takeTravelFriction(const TravelFriction& friction, const std::optional<Bench>& bench, Commission& axis);

}  // namespace breakaway
