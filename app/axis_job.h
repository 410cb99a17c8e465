// A linear axis' measurements as runs for the I/O thread: what each needs, in which order, and what it leaves behind.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "commission/travel_plan.h"
#include "identify/motor_identification.h"
#include "run.h"

namespace breakaway {

struct AxisHomingRequest {
  Identity board;
  ControllerSettings settings;
  std::optional<Identification> identification;  ///< without one the motor is identified on the way
  std::optional<double> trustedForceConstant_N_per_A;
  CurrentScaleOptions scale;
};

/// What sweeps over a homed axis need; positions as the encoder counts them.
struct AxisSweepRequest {
  KnownAxis axis;
  TravelPace pace;
  TravelBins bins;
  std::optional<Identification> identification;
};

/// Current sensor's zero, both ends, the motor where it isn't known (winding test, strokes by voltage), and the index;
/// without an index the lower end takes its place.
Run axisHomingRun(const AxisHomingRequest& request);

/// Strokes at `speeds` speeds up to the pace's, at least `run_s` each. `earlier`: those of an interrupted sweep,
/// which goes on if its speeds were the same ones.
Run strokesRun(const AxisSweepRequest& request, size_t speeds, double run_s, const std::vector<TravelRun>& earlier);

/// The breakaway sweep over the travel, `passes` times each way. `strokes`: of the velocity sweep, they tell what keeps
/// it moving. `earlier`: the breakaways of an interrupted sweep, counted from the index, as those that it leaves.
/// Errors: movingCurrent_A()'s.
Result<Run> travelBreakawayRun(const AxisSweepRequest& request, size_t passes, const std::vector<TravelRun>& strokes,
                               const std::vector<BreakawayEvent>& earlier);

/// A step in velocity that begins at the lower margin, and the whole with the way there.
struct AxisStep {
  std::shared_ptr<Procedure> whole;
  std::shared_ptr<VelocityStep> step;
};
AxisStep stepOver(const KnownAxis& axis, const TravelPace& pace, const VelocityStepOptions& options);
/// The highest velocity of such a step: as far as it goes and coasts, it stays between the margins.
double highestStep_m_per_s(const KnownAxis& axis, const TravelPace& pace, const VelocityStepOptions& options);

/// Parts of the highest speed that a sweep runs at, from 1.2 % of it in equal ratios, in an order in which speed and
/// time have little to do with each other.
std::vector<double> strokeParts(size_t speeds);

}  // namespace breakaway
