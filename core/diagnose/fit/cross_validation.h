// How well a fit predicts what it did not see, and whether one fit is better than another.
#pragma once

#include <vector>

#include "base/statistics.h"
#include "diagnose/fit/windowed_fit.h"

namespace breakaway {

/// Mean squared residual per window in units of `unit` (times the window's squared weight), positions' and currents'
/// added up, each simulated with the parameters that a fit to the other folds would have: one Gauss–Newton step from
/// the common fit, halved while the other folds themselves err more. At most ten units: how far a window runs away
/// says no more than that it does.
std::vector<double> crossValidated(const FitResult& fit, const std::vector<Track>& tracks,
                                   const std::vector<Window>& windows, const std::vector<double>& windowWeights,
                                   const std::vector<int>& fold, int foldCount, Weights unit);

struct Comparison {
  double relative = 0.0;  ///< mean improvement over the mean of the worse
  Interval interval;      ///< 95 %, of `relative`
  double inErrors = 0.0;  ///< mean improvement in standard errors
};

/// How much smaller `after` is than `before`, window by window.
Comparison compare(const std::vector<double>& before, const std::vector<double>& after, std::uint64_t seed);

/// p-value of the windows' errors falling together: sign flips of the differences of their roots, one-sided.
double signFlipPValue(const std::vector<double>& before, const std::vector<double>& after, std::uint64_t seed);

}  // namespace breakaway
