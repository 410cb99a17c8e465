// Quantiles and tails of the distributions that intervals and tests rest on.
#pragma once

#include <cstddef>

namespace breakaway {

/// Student's distribution, its 97.5 % quantile for `freedom` degrees, at least 1: half a 95 % interval in standard
/// errors that rest on few independent pieces.
double student95(double freedom);

/// Standard deviations of a normal distribution that are exceeded, either way, with this chance, in (0, 1).
double deviationsOf(double chance);

/// One-sided 95 % upper bound of a probability after `hits` of `runs` (C. Clopper, E. Pearson, Biometrika 26(4), 1934):
/// the largest one at which so few hits still come up in 5 % of cases; 1 for no runs.
double upperBound95(std::size_t hits, std::size_t runs);

/// Probability that χ² with `freedom` > 0 degrees exceeds `value` ≥ 0.
double chiSquareTail(double value, double freedom);

}  // namespace breakaway
