#include "experiment/compensation.h"

#include <algorithm>

namespace breakaway {

namespace {

constexpr double linearBlend_m_per_s = 0.002;

/// Means over `bins` equal groups of neighbours; `bins` divides their count.
template <typename Get>
std::vector<double> grouped(const FrictionMap& map, size_t bins, Get get) {
  std::vector<double> means(bins, 0.0);
  const size_t all = map.bins.size();
  for (size_t group = 0; group < bins; ++group) {
    const size_t from = group * all / bins, to = (group + 1) * all / bins;
    for (size_t k = from; k < to; ++k) means[group] += get(map.bins[k]) / static_cast<double>(to - from);
  }
  return means;
}

}  // namespace

FrictionCompensation compensationOf(const FrictionMap& map, CompensatedFriction part, double indexAngle_rad,
                                    size_t mostBins) {
  FrictionCompensation friction;
  friction.indexAngle_rad = indexAngle_rad;
  if (map.axis == Axis::linear) friction.blend_rad_per_s = linearBlend_m_per_s;
  if (part == CompensatedFriction::none || map.bins.empty()) return friction;
  if (map.axis == Axis::linear && map.bins.size() > 1) {
    const double width_m = map.bins[1].angle_rad - map.bins[0].angle_rad;
    friction.span_rad = width_m * static_cast<double>(map.bins.size());
    friction.indexAngle_rad += map.bins[0].angle_rad - 0.5 * width_m;
  }
  size_t bins = part == CompensatedFriction::map ? map.bins.size() : 1;
  if (bins > mostBins) {
    // Groups of equal width, so that the table's bins lie where the board looks for them.
    bins = mostBins;
    while (map.bins.size() % bins != 0) --bins;
  }
  friction.stribeck_rad_per_s = map.stribeckVelocity_rad_per_s.value;
  for (size_t way = 0; way < 2; ++way) {
    if (friction.stribeck_rad_per_s > 0.0)
      friction.static_Nm[way] = grouped(map, bins, [way](const MapBin& bin) { return bin.way[way].static_Nm.value; });
    friction.coulomb_Nm[way] = grouped(map, bins, [way](const MapBin& bin) { return bin.way[way].coulomb_Nm.value; });
    friction.viscous_Nm_s_per_rad[way] =
        part == CompensatedFriction::coulomb
            ? std::vector<double>(bins, 0.0)
            : grouped(map, bins, [way](const MapBin& bin) { return bin.way[way].viscous_Nm_s_per_rad.value; });
  }
  return friction;
}

}  // namespace breakaway
