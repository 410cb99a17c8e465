#include "session/shown_maps.h"

#include <algorithm>

namespace breakaway {

void ShownMaps::open(const std::optional<KeptMap>& map) {
  opened_ = map;
  emit changed();
}

void ShownMaps::layBeneath(const std::optional<KeptMap>& map) {
  earlier_ = map;
  emit changed();
}

Commission commissionOf(const FrictionMap& map) {
  Commission known;
  known.identity.axis = map.axis;
  known.sweeps.bins = map.bins.size();
  known.sweeps.turns = map.turns;
  known.map = map;
  known.facts.add({Known::map});
  const bool moved = std::any_of(map.bins.begin(), map.bins.end(),
                                 [](const MapBin& bin) { return bin.way[0].coulomb_Nm.value != 0.0; });
  if (moved) known.facts.add({Known::runs});
  if (map.axis == Axis::linear && map.bins.size() > 1) {
    const double half_m = 0.5 * (map.bins[1].angle_rad - map.bins[0].angle_rad);
    known.travel = Travel{map.bins.front().angle_rad - half_m, map.bins.back().angle_rad + half_m, 0.0};
  }
  return known;
}

}  // namespace breakaway
