// How a parameter is spread over a fleet, and how it goes with the date.
#pragma once

#include <optional>
#include <vector>

#include "draw/svg_plot.h"
#include "fleet/spread.h"

namespace breakaway {

/// How many entries have which value, with what stands out as points on the axis. Values further than eight robust
/// deviations from the median lie beyond its ends.
Figure spreadFigure(const FleetColumn& column);
/// Values that spreadFigure() leaves out.
size_t beyondSpread(const FleetColumn& column);

/// The median by date with the middle half of the entries, over days since the first date; nothing where fewer than two
/// days are dated.
std::optional<Figure> trendFigure(const FleetColumn& column, const std::vector<FleetEntry>& entries);

}  // namespace breakaway
