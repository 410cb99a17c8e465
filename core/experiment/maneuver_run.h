// An experiment's motion on a board, within its limits and an axis' travel.
#pragma once

#include <optional>

#include "experiment/timed_procedure.h"
#include "experiment/travel.h"
#include "motor/maneuver.h"

namespace breakaway {

struct ManeuverLimits {
  double speed = 0.0;                 ///< rad/s or m/s: speeds are cut there, and no current drives beyond it; 0: none
  double current_A = 0.0;             ///< likewise
  std::optional<Travel> travel = {};  ///< of a linear axis, as the encoder counts it: before its margins the way turns
  double braking = 0.0;               ///< m/s² that it surely stops with there; 0: at once
};

/// Zeroes the current sensor first, where the board does. Fails in words when nothing moves though it should.
class ManeuverRun : public TimedProcedure {
 public:
  ManeuverRun(Maneuver motion, const ManeuverLimits& limits, bool zeroes, Axis axis);

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override { return timed(elapsed_s_, whole_s_, message("running the experiment")); }

 private:
  Command follow(const ManeuverStretch& stretch, double time_s, const Sample& sample);
  void watchMotion(const Command& command, const Sample& sample);

  Maneuver motion_;
  ManeuverLimits limits_;
  Axis axis_;
  double zeroing_s_, whole_s_;
  double elapsed_s_ = 0.0, begun_s_ = 0.0;  ///< begun_s_: of the stretch that runs, since the first sample
  size_t at_ = 0;
  double way_ = 1.0;  ///< −1: a margin has turned it
  double movedAngle_ = 0.0, stalled_s_ = 0.0;
};

}  // namespace breakaway
