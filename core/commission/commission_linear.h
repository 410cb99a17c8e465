// The whole bench job on a linear axis.
#pragma once

#include "base/result.h"
#include "commission/commission.h"

namespace breakaway {

/// What commission() does on a board with a linear axis: current sensor's zero, both ends of the travel, winding test,
/// strokes by voltage, homing to the index (or to the lower end where there is none), strokes at several speeds,
/// breakaway sweep over the travel, map, tuning of medium stiffness, a run with and without the map. Bins lie over the
/// travel between the margins; turns are passes. Errors and resumption as for commission(); a resumed job feels for the
/// ends and homes anew.
Result<Commission> commissionLinear(Drive& drive, const CommissionOptions& options);

}  // namespace breakaway
