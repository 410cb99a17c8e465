// One ramp of the breakaway sweep: its plan, what was seen on it, and what the rotor let go at.
#pragma once

#include <cstddef>
#include <vector>

#include "control/leg/breakaway_leg.h"
#include "experiment/breakaway_lag.h"
#include "friction/measurements.h"

namespace breakaway {

/// Currents positive in the way's direction.
using RampPlan = RampShape<double>;

struct RampRow {
  double time_s = 0.0;  ///< since the ramp began
  double commanded_A = 0.0, measured_A = 0.0, angle_rad = 0.0;
};

class BreakawayRamp {
 public:
  BreakawayRamp() = default;
  /// `sign`: of the way, 1 or −1; `countAngle_rad` of the encoder; `mostEdges` counts date the motion.
  BreakawayRamp(const RampPlan& plan, double sign, double standing_rad, double countAngle_rad, size_t mostEdges)
      : plan_(plan), sign_(sign), standing_rad_(standing_rad), count_rad_(countAngle_rad), mostEdges_(mostEdges) {}

  const RampPlan& plan() const { return plan_; }
  double standing_rad() const { return standing_rad_; }
  double commandedAt(double inRamp_s) const;
  void add(const RampRow& row) { rows_.push_back(row); }
  bool empty() const { return rows_.empty(); }

  /// Currents, lag and time (since the ramp began) of the breakaway that ended it: dated back to the last standing row,
  /// less the time that the rotor needed for its first count. Precondition: at least one row.
  BreakawayEvent event(const BreakawayLag& motor, double tick_s) const;

 private:
  double rateAt(double commanded_A) const;
  size_t lastStanding(const BreakawayLag& motor) const;
  std::vector<double> edgesAfter(size_t standing) const;

  RampPlan plan_;
  double sign_ = 1.0, standing_rad_ = 0.0, count_rad_ = 0.0;
  size_t mostEdges_ = 0;
  std::vector<RampRow> rows_;
};

}  // namespace breakaway
