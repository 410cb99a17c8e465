// Slow motion over uneven friction: compensated on average, and angle by angle.
#pragma once

#include "base/result.h"
#include "figures/bench_figure.h"
#include "figures/commissioned_bench.h"

namespace breakaway {

struct SlowMotionOptions {
  double speed_rad_per_s = 5.0;
  double turns = 2.0;
  double halfSpan_s = 0.01;  ///< speeds are central differences of the angle over ± this time
};

/// The velocity at a slow constant speed under the velocity controller with disturbance feedback: without compensation,
/// with the average (F + B·ω) and with the measured map; and the same under proportional control alone. Key numbers:
/// the rms velocity errors, and how many times smaller the map makes them than the average. Errors: the course's, the
/// drive's.
Result<BenchFigure> slowMotionFigure(CommissionedBench& bench, const SlowMotionOptions& options = {});

}  // namespace breakaway
