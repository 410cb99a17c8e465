#include "friction/static_average.h"

namespace breakaway {

Estimate staticAverage_Nm(const FrictionMap& map, Way way) {
  Estimate sum;
  for (const MapBin& bin : map.bins) {
    const Estimate& one = bin.way[static_cast<size_t>(way)].static_Nm;
    sum.value += one.value;
    sum.standardError += one.standardError;
  }
  if (map.bins.empty()) return {};
  const auto count = static_cast<double>(map.bins.size());
  return {sum.value / count, sum.standardError / count};
}

Estimate staticAverage_Nm(const FrictionMap& map) {
  const Estimate cw = staticAverage_Nm(map, Way::cw), ccw = staticAverage_Nm(map, Way::ccw);
  return {0.5 * (cw.value + ccw.value), 0.5 * (cw.standardError + ccw.standardError)};
}

}  // namespace breakaway
