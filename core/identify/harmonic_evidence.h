// Which harmonics of a curve around the rotor are there, and which are no more than noise.
#pragma once

#include <complex>
#include <vector>

namespace breakaway {

/// What data say of one harmonic, and what was expected of it before. Variances are those of the real and of the
/// imaginary part; infinite: the data say nothing.
struct HarmonicEvidence {
  std::complex<double> value = 0.0;
  double variance = 0.0;
  std::complex<double> expected = 0.0;
  double expectedVariance = 0.0;
  double chance = 1.0;  ///< of being there, part of the prior's share
};

/// How curves of this kind vary: a share of the orders differs from what was expected by normal amounts of this
/// variance in each part, the others don't.
struct HarmonicPrior {
  double share = 0.0;
  double variance = 0.0;
};

/// Fine harmonics of friction are rarer than coarse ones: 1 up to the order `coarse`, then falling with its fourth
/// power.
double chanceOf(size_t order, double coarse);

struct WeighedHarmonic {
  std::complex<double> value = 0.0;
  double variance = 0.0;  ///< of each part, the doubt whether it is there included
};

/// Mean and variance of the harmonic, given the evidence: between the case that it is there and the case that it isn't,
/// each by its probability (the mixture prior of Mitchell and Beauchamp, "Bayesian variable selection in linear
/// regression", J. Am. Stat. Assoc. 83, 1988).
WeighedHarmonic weighed(const HarmonicEvidence& evidence, const HarmonicPrior& prior);

/// The prior that a curve's own harmonics suggest, by expectation and maximisation from `start`, which itself counts as
/// `startOrders` further orders.
HarmonicPrior learnt(const std::vector<HarmonicEvidence>& orders, const HarmonicPrior& start, double startOrders);

}  // namespace breakaway
