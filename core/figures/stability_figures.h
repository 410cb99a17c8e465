// Where the commissioned loop's poles go when the observer's cutoff grows.
#pragma once

#include <vector>

#include "base/result.h"
#include "figures/bench_figure.h"
#include "figures/commissioned_bench.h"

namespace breakaway {

/// The root locus over the cutoff of the velocity loop around the motor that was measured, with the gains that
/// commissioning tuned: in the z plane, and near the origin as s = ln(z)/T with arrows for a growing cutoff. Key
/// numbers: the tuned cutoff, from where the loop is less damped than 0.707 and unstable (where it is met), and the
/// rule of thumb α·g·T = 0.3. Errors: those of loopOfBench().
Result<std::vector<BenchFigure>> rootLociOfBench(const CommissionedBench& bench);

}  // namespace breakaway
