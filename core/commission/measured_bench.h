// The bench file that a commissioning leaves.
#pragma once

#include "commission/commission.h"
#include "motor/bench.h"

namespace breakaway {

/// The options' own bench, or a new one, with what was measured in it, and the controller that the job has set.
/// Recordings show the current as the sensor does; with it go the motor's constant and winding.
Bench measuredBench(const Commission& done, const CommissionOptions& options);

}  // namespace breakaway
