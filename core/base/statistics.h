// Small statistics on plain arrays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/random.h"

namespace breakaway {

/// Arithmetic mean; 0 for an empty span.
double mean(std::span<const double> values);
/// Root of the mean square; 0 for an empty span.
double rms(std::span<const double> values);
/// Quantile in [0, 1] by partial sorting of the given copy, without interpolation; 0 for no values.
double quantile(std::vector<double> values, double fraction);

/// 95 % interval of `statistic` over resampled blocks (percentile bootstrap): calls it with block indices drawn with
/// replacement.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};
template <typename Statistic>
Interval bootstrap(size_t blocks, size_t draws, std::uint64_t seed, Statistic statistic) {
  Random random(seed);
  std::vector<double> values;
  std::vector<size_t> chosen(blocks);
  for (size_t draw = 0; draw < draws; ++draw) {
    for (size_t& one : chosen) one = random.below(blocks);
    values.push_back(statistic(std::span<const size_t>(chosen)));
  }
  return {quantile(values, 0.025), quantile(values, 0.975)};
}

}  // namespace breakaway
