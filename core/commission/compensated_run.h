// The same slow to and fro with and without the measured friction compensated: what the map is good for on this bench.
#pragma once

#include <optional>

#include "base/result.h"
#include "commission/commission.h"
#include "commission/commission_steps.h"

namespace breakaway {

struct CompensatedRunOptions {
  double amplitude_rad_per_s = 5.0;  ///< of a sine of speed, so slow that the loop follows it
  double period_s = 4.0;
  double periods = 1.5;
  std::optional<double> start_rad;  ///< where the course begins; anywhere where it is missing
  double halfSpan_s = 0.005;        ///< speeds are central differences of the angle over ± this time
};

/// Runs the course by the velocity controller without compensation, uploads the map with Drive::compensate(), runs it
/// again, and ends the compensation. `done` must hold the map and the index; what comes out goes into
/// done.compensatedRun. A board that takes no compensation, or a run that fails, leaves a remark in `done`. Errors: the
/// job was stopped.
Result<void> runCompensated(Drive& drive, CommissionSteps& steps, Commission& done,
                            const CompensatedRunOptions& options = {});

}  // namespace breakaway
