// The current's response to a square wave of the voltage, averaged over its edges.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/estimate.h"
#include "base/result.h"
#include "recording/sample.h"

namespace breakaway {

/// Edges are dated by the voltage that the samples show, not by the commands: on the way to a board a command takes as
/// long as it likes. After a gap in the samples, nothing counts until the next edge.
class SquareResponse {
 public:
  /// `ticks` of `tick_s` after an edge are averaged.
  SquareResponse(size_t ticks, double tick_s) : tick_s_(tick_s), sums_(2 * ticks, 0.0), counts_(2 * ticks, 0) {}

  /// Every sample while the square wave is on.
  void take(const Sample& sample);

  /// Mean current by ticks after an edge, (after a rise − after a fall)/2, as far as both were seen.
  std::vector<double> current_A() const;
  double tick_s() const { return tick_s_; }
  /// Mean time from one edge to the next; 0: none was seen from edge to edge.
  double halfPeriod_s() const { return halves_ > 0 ? halves_s_ / static_cast<double>(halves_) : 0.0; }

 private:
  double tick_s_;
  std::vector<double> sums_;  ///< after rises, then after falls
  std::vector<size_t> counts_;
  double last_s_ = 0.0, edge_s_ = 0.0, halves_s_ = 0.0;
  size_t edges_ = 0, halves_ = 0;  ///< edges since the last gap
  bool begun_ = false, high_ = false;
};

/// The winding's time constant L/R: the response after a step of a square wave of half period T is
/// I·(1 − 2·e^(−t/τ)/(1 + e^(−T/τ))); least squares in τ with I free. In s, with its standard error.
/// Errors: fewer than 4 ticks, no response above the noise.
Result<Estimate> fitTimeConstant(const SquareResponse& response);

}  // namespace breakaway
