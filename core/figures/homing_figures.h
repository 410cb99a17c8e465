// Where the index is seen, both ways.
#pragma once

#include "base/result.h"
#include "figures/bench_figure.h"
#include "figures/commissioned_bench.h"

namespace breakaway {

struct IndexPassesOptions {
  double speed_rad_per_s = 0.8;  ///< homing's own for its approaches
  double reach_rad = 0.1;        ///< to either side of the index
  size_t passes = 12;            ///< each way
};

/// The place of each passage of the index, from where homing found it, the rotor going to and fro over it under the
/// position controller. A place is half way between the sample before and the first that shows the index. Key numbers:
/// the mean place each way and its scatter, how far both ways are apart, and how many passages there were. Errors: the
/// course's; no passage both ways.
Result<BenchFigure> indexPassesFigure(CommissionedBench& bench, const IndexPassesOptions& options = {});

}  // namespace breakaway
