// Two smooth curves over a stretch from one noisy pair of values at each of many places.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "base/estimate.h"

namespace breakaway {

struct SmoothPair {
  std::vector<Estimate> first, second;  ///< at the places
  Estimate firstMean, secondMean;       ///< over all places
};

/// Gaussian process regression (Rasmussen and Williams, "Gaussian Processes for Machine Learning", 2006, equations 2.23
/// to 2.24): each curve is a constant, of which nothing is known, plus a part with the covariance s²·exp(−d²/2ℓ²); s
/// and ℓ of both are those under which the measured pairs are likeliest (equation 2.30), among a grid, and each curve
/// is then weighed over its own. `measured` and `covariance` hold one pair per place; a place without a measurement has
/// a large covariance. `place` rises from 0 to 1. Unlike harmonics this asks nothing of a curve's ends. Precondition:
/// at least two places, all of equal length.
SmoothPair smoothPair(const std::vector<double>& place, const std::vector<Eigen::Vector2d>& measured,
                      const std::vector<Eigen::Matrix2d>& covariance);

}  // namespace breakaway
