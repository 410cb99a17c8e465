#include "identify/harmonic_evidence.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr double mostShare = 0.9;
constexpr int evidenceRounds = 40;  // of expectation and maximisation; it settles within ten

/// Posterior of a deviation d known with variance v, drawn from variance p.
struct Drawn {
  Drawn(double p, double v)
      : gain(std::isinf(v) ? 0.0 : p / std::max(1e-300, p + v)), variance(std::isinf(v) ? p : gain * v) {}
  double gain, variance;
};

struct Cases {
  double there = 0.0;  ///< probability
  Drawn with, without;
};

Cases casesOf(const HarmonicEvidence& one, const HarmonicPrior& prior) {
  const double narrow = one.expectedVariance, wide = narrow + prior.variance;
  const double share = prior.share * one.chance;
  Cases cases{share, Drawn(wide, one.variance), Drawn(narrow, one.variance)};
  if (std::isinf(one.variance)) return cases;
  const double a = std::max(1e-300, narrow + one.variance), b = std::max(1e-300, wide + one.variance);
  const double exponent = 0.5 * std::norm(one.value - one.expected) * (1.0 / a - 1.0 / b);
  const double odds = share / (1.0 - share) * a / b * std::exp(std::min(600.0, exponent));
  cases.there = odds / (1.0 + odds);
  return cases;
}

}  // namespace

double chanceOf(size_t order, double coarse) {
  const double part = coarse / std::max(coarse, static_cast<double>(order));
  return part * part * part * part;
}

WeighedHarmonic weighed(const HarmonicEvidence& evidence, const HarmonicPrior& prior) {
  const Cases cases = casesOf(evidence, prior);
  const double there = cases.there, not_ = 1.0 - there;
  const std::complex<double> off = std::isinf(evidence.variance) ? 0.0 : evidence.value - evidence.expected;
  const double between = 0.5 * there * not_ * std::norm((cases.with.gain - cases.without.gain) * off);
  return {evidence.expected + (there * cases.with.gain + not_ * cases.without.gain) * off,
          there * cases.with.variance + not_ * cases.without.variance + between};
}

HarmonicPrior learnt(const std::vector<HarmonicEvidence>& orders, const HarmonicPrior& start, double startOrders) {
  HarmonicPrior prior = start;
  const double startShare = startOrders * start.share;
  for (int round = 0; round < evidenceRounds; ++round) {
    double there = startShare, squares = startShare * start.variance, count = startOrders;
    for (const HarmonicEvidence& one : orders) {
      if (std::isinf(one.variance)) continue;
      const Cases cases = casesOf(one, prior);
      const double square = 0.5 * std::norm(cases.with.gain * (one.value - one.expected)) + cases.with.variance;
      there += cases.there;
      squares += cases.there * std::max(0.0, square - one.expectedVariance);
      count += one.chance;
    }
    prior = {std::min(mostShare, there / count), squares / there};
  }
  return prior;
}

}  // namespace breakaway
