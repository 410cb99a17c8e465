// The bench file that a commissioning leaves.
#pragma once

#include "commission/commission.h"
#include "motor/bench.h"

namespace breakaway {

/// The options' own bench, or a new one, with what was measured in it; its controller is left as it was. Recordings
/// show the current as the sensor does; with it go the motor's constant and winding, `shownResistance_ohm` too.
Bench measuredBench(const Commission& done, const CommissionOptions& options, double shownResistance_ohm);

}  // namespace breakaway
