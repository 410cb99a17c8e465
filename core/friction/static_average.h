// Static friction on average over a map.
#pragma once

#include "friction/friction_map.h"

namespace breakaway {

/// Mean over all bins, both ways. All bins share their errors, such as that of the current sensor's zero: averaging
/// makes them no smaller. 0 of an empty map. In N on a linear axis.
Estimate staticAverage_Nm(const FrictionMap& map);
/// The same one way: what starts motion that way.
Estimate staticAverage_Nm(const FrictionMap& map, Way way);

}  // namespace breakaway
