// All that both sweeps say of a linear axis' friction, put together.
#pragma once

#include <array>
#include <vector>

#include "base/result.h"
#include "friction/friction_map.h"
#include "friction/measurements.h"
#include "identify/map_estimation.h"
#include "identify/travel_friction.h"
#include "identify/travel_map.h"

namespace breakaway {

/// At which a travel's map gives the total force.
inline constexpr double travelTotalVelocity_m_per_s = 0.1;

struct TravelSurvey {
  TravelFriction friction;  ///< slow strokes freed of what friction falls by with speed
  FrictionMap map;          ///< with the Stribeck speed, where slow strokes show it
};

/// `moving`: of fitTravelFriction() without breakaways. Once the breakaway forces are known, slow strokes can be freed
/// of what friction falls by with speed, and the map is drawn upon what is left. Events as the encoder counts them;
/// `index_m` likewise. Errors: those of estimateTravelMap() and fitTravelFriction().
Result<TravelSurvey> surveyTravel(const std::vector<BreakawayEvent>& events, const std::vector<TravelRun>& strokes,
                                  const std::array<MovingFriction, 2>& moving, TravelFrictionOptions friction,
                                  double index_m, const MapOptions& options);

}  // namespace breakaway
