// Speed afterwards, from the angle before and after: no lag, and little of the encoder's rounding.
#pragma once

#include <vector>

#include "recording/sample.h"

namespace breakaway {

struct SpeedCurve {
  std::vector<double> time_s, velocity_rad_per_s;
};

/// Central differences of the angle over ± `halfSpan_s`, at least one sample, for all samples that have both
/// neighbours. Precondition: evenly spaced samples.
SpeedCurve centralDifference(const std::vector<Sample>& samples, double halfSpan_s);

}  // namespace breakaway
