// The order of a breakaway sweep: every place one way, then back, some times; and what it has measured.
#pragma once

#include <cstddef>
#include <vector>

#include "friction/measurements.h"

namespace breakaway {

class BreakawayTour {
 public:
  /// `earlier` are the breakaways of an interrupted sweep with the same bins; they are kept, and their steps left out.
  BreakawayTour(size_t bins, size_t passes, const std::vector<BreakawayEvent>& earlier);

  Way way() const { return (step_ / bins_) % 2 == 0 ? Way::ccw : Way::cw; }
  double sign() const { return signOf(way()); }
  size_t bin() const;
  /// Both ways are one pass.
  size_t pass() const { return step_ / (2 * bins_); }
  size_t oneWay() const { return step_ / bins_; }
  bool ended() const { return step_ >= done_.size(); }
  /// To the next step that is not done.
  void advance();
  /// A breakaway at the present step. It is an outlier where it is further from the median of the five before it the
  /// same way than half of that: no neighbour's value.
  void take(BreakawayEvent event);
  /// All breakaways so far, in the order they were measured.
  const std::vector<BreakawayEvent>& events() const { return events_; }
  double progress() const { return static_cast<double>(step_) / static_cast<double>(done_.size()); }
  /// After `elapsed_s`; `usual_s` a step takes, until that is known.
  double remaining_s(double elapsed_s, double usual_s) const;

 private:
  void skipDone();
  size_t stepOf(const BreakawayEvent& event) const;

  size_t bins_ = 0, step_ = 0;
  std::vector<bool> done_;  ///< by step, of an earlier part
  std::vector<BreakawayEvent> events_;
};

}  // namespace breakaway
