#include "commission/travel_survey.h"

namespace breakaway {

Result<TravelSurvey> surveyTravel(const std::vector<BreakawayEvent>& events, const std::vector<TravelRun>& strokes,
                                  const std::array<MovingFriction, 2>& moving, TravelFrictionOptions friction,
                                  double index_m, const MapOptions& options) {
  const auto still = estimateTravelMap(events, moving, friction.bins, index_m, options);
  if (!still) return still.error();
  for (const MapBin& bin : still->bins) {
    for (size_t w = 0; w < 2; ++w) friction.static_N[w].push_back(bin.way[w].static_Nm.value);
  }
  auto fitted = fitTravelFriction(strokes, friction);
  if (!fitted) return fitted.error();
  auto map = estimateTravelMap(events, fitted->moving, friction.bins, index_m, options);
  if (!map) return map.error();
  map->stribeckVelocity_rad_per_s = fitted->stribeck_m_per_s;
  return TravelSurvey{std::move(*fitted), std::move(*map)};
}

}  // namespace breakaway
