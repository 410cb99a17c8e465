#include "experiment/breakaway_ramp.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {
constexpr double leastStand_s = 0.03;  // on one count, of a rotor that stands
constexpr size_t leastRampRows = 20;
constexpr double settledTimes = 7.0;  // L/R, after which a thousandth of a step is left
}  // namespace

double BreakawayRamp::commandedAt(double inRamp_s) const {
  return rampCurrent(plan_, inRamp_s);
}

double BreakawayRamp::rateAt(double commanded_A) const {
  if (!plan_.learning) return plan_.rate_A_per_s;
  return std::log(2.0) / RampPlan::learningDoubling_s * std::max(0.0, commanded_A - plan_.start_A);
}

/// The last row before the motion: back to the first count on which it stayed longer than a rotor does that has let go.
/// A count gained earlier is elastic travel, or the encoder's slip, and no motion.
size_t BreakawayRamp::lastStanding(const BreakawayLag& motor) const {
  const double most_s = std::max(leastStand_s, 2.0 * motionLag_s(motor, rateAt(rows_.back().commanded_A), count_rad_));
  size_t last = rows_.size() - 1;
  for (size_t k = rows_.size() - 1; k > 0; --k) {
    const bool same = std::abs(rows_[k].angle_rad - rows_[k - 1].angle_rad) < 0.5 * count_rad_;
    if (!same) last = k - 1;
    if (rows_[last].time_s - rows_[k - 1].time_s > most_s) return last;
  }
  return last;
}

/// When the counts after the last standing row followed, halfway between the rows that show them.
std::vector<double> BreakawayRamp::edgesAfter(size_t standing) const {
  std::vector<double> edges_s;
  for (size_t k = standing + 1; k < rows_.size() && edges_s.size() < mostEdges_; ++k) {
    const double counts = sign_ * (rows_[k].angle_rad - standing_rad_) / count_rad_;
    const double halfway_s = 0.5 * (rows_[k].time_s + rows_[k - 1].time_s);
    while (static_cast<double>(edges_s.size()) + 0.5 < counts && edges_s.size() < mostEdges_)
      edges_s.push_back(halfway_s);
  }
  return edges_s;
}

BreakawayEvent BreakawayRamp::event(const BreakawayLag& motor, double tick_s) const {
  size_t standing = lastStanding(motor);
  const double rate = rateAt(rows_[standing].commanded_A);
  BreakawayLag moving = motor;
  moving.friction_A = rows_[standing].commanded_A;
  const double lag_s = likelyMotionLag_s(moving, rate, count_rad_, edgesAfter(standing), tick_s);
  // The winding's current gives way to the back-EMF as soon as it moves.
  const size_t moved = standing;
  while (standing > leastRampRows && rows_[standing - 1].time_s > rows_[moved].time_s - lag_s) --standing;
  BreakawayEvent event;
  event.time_s = rows_[moved].time_s - lag_s;
  event.commanded_A = std::max(plan_.start_A, rows_[moved].commanded_A - rate * lag_s);
  event.lag_A = rate * lag_s;
  // Sums over the standing part; a learning ramp counts only where it is within a factor of two of its end, another
  // once the current has come after its first step: a winding that takes T for it would make static friction by
  // 2·T/ramp_s of that step too large.
  size_t first = 0;
  while (!plan_.learning && first + leastRampRows < standing &&
         rows_[first].time_s - rows_.front().time_s < settledTimes * motor.windingTime_s)
    ++first;
  while (plan_.learning && first + leastRampRows < standing && rows_[first].commanded_A < 0.5 * event.commanded_A)
    ++first;
  double xx = 0.0, xy = 0.0, x = 0.0, y = 0.0;
  for (size_t k = first; k <= standing; ++k) {
    x += rows_[k].commanded_A, y += rows_[k].measured_A;
    xx += rows_[k].commanded_A * rows_[k].commanded_A, xy += rows_[k].commanded_A * rows_[k].measured_A;
  }
  const auto n = static_cast<double>(standing + 1 - first);
  event.samples = standing + 1 - first;
  event.commandedMean_A = x / n;
  event.measuredMean_A = y / n;
  event.commandedVariance_A2 = xx / n - x / n * x / n;
  event.covariance_A2 = xy / n - x / n * y / n;
  event.current_A = event.measuredMean_A + (event.commanded_A - event.commandedMean_A);
  return event;
}

}  // namespace breakaway
