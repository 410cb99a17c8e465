// From breakaways and strokes over a linear axis' travel to its friction map.
#pragma once

#include <array>
#include <vector>

#include "base/result.h"
#include "experiment/travel_bins.h"
#include "friction/friction_map.h"
#include "identify/map_estimation.h"
#include "identify/velocity_friction.h"

namespace breakaway {

/// All bins of both ways, filled; `index_m` is where positions are counted from. Static: what each pass measured over
/// the moving friction, straight between the places where the axis really stood, upon the moving friction at the bin's
/// centre; mean over passes; standard errors as in estimateMap(), `options` likewise (turns are passes, rad m). Errors:
/// a way with fewer than 8 breakaways in a pass.
Result<FrictionMap> estimateTravelMap(const std::vector<BreakawayEvent>& events,
                                      const std::array<MovingFriction, 2>& moving, const TravelBins& bins,
                                      double index_m, const MapOptions& options);

}  // namespace breakaway
