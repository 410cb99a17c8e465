#include "experiment/central_difference.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

SpeedCurve centralDifference(const std::vector<Sample>& samples, double halfSpan_s) {
  SpeedCurve speed;
  if (samples.size() < 2) return speed;
  const double tick_s = samples[1].time_s - samples[0].time_s;
  const auto reach = static_cast<size_t>(std::max(1.0, std::round(halfSpan_s / tick_s)));
  for (size_t k = reach; k + reach < samples.size(); ++k) {
    const Sample &before = samples[k - reach], &after = samples[k + reach];
    speed.time_s.push_back(samples[k].time_s);
    speed.velocity_rad_per_s.push_back((after.angle_rad - before.angle_rad) / (after.time_s - before.time_s));
  }
  return speed;
}

}  // namespace breakaway
