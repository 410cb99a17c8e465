#include "diagnose/verdict/proof.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "base/statistics.h"
#include "diagnose/fit/torque_residual.h"
#include "diagnose/simulate/simulation.h"

namespace breakaway {

namespace {

constexpr size_t mostLags = 10;
constexpr double outlier = 3.0;  ///< robust standard deviations: what lies beyond counts as lying there

/// Centred, outliers drawn in, gaps left as NaN.
std::vector<double> tamed(std::vector<double> series) {
  std::vector<double> known;
  std::copy_if(series.begin(), series.end(), std::back_inserter(known), [](double x) { return std::isfinite(x); });
  const double middle = quantile(known, 0.5);
  for (double& one : known) one = std::abs(one - middle);
  const double reach = outlier * quantile(known, 0.5) / 0.6745;
  double sum = 0.0;
  for (double& one : series) {
    one = std::isfinite(one) ? std::clamp(one - middle, -reach, reach) : one;
    sum += std::isfinite(one) ? one : 0.0;
  }
  for (double& one : series) one -= sum / static_cast<double>(std::max<size_t>(known.size(), 1));
  return series;
}

}  // namespace

Whiteness whitenessOf(const std::vector<double>& raw) {
  const std::vector<double> series = tamed(raw);
  double square = 0.0, n = 0.0;
  for (const double one : series) {
    if (!std::isfinite(one)) continue;
    square += one * one;
    n += 1.0;
  }
  Whiteness out;
  if (n < 8.0 || square <= 0.0) return out;
  double q = 0.0, degrees = 0.0;
  for (size_t lag = 1; lag <= std::min(mostLags, static_cast<size_t>(n) / 4); ++lag) {
    double sum = 0.0, pairs = 0.0;
    for (size_t k = lag; k < series.size(); ++k) {
      const double product = series[k] * series[k - lag];
      if (!std::isfinite(product)) continue;
      sum += product;
      pairs += 1.0;
    }
    if (pairs < 4.0) continue;
    const double correlation = sum / pairs / (square / n);
    if (lag == 1) out.lag1 = std::clamp(correlation, -1.0, 1.0);
    q += pairs * (n + 2.0) / n * correlation * correlation;  // with gaps a correlation's variance is 1/pairs
    degrees += 1.0;
  }
  if (degrees > 0.0) out.pValue = chiSquareTail(q, degrees);
  return out;
}

Proof proofOf(const Model& best, const std::vector<Track>& tracks, const std::vector<Window>& heldout,
              const std::vector<double>& before, const std::vector<double>& after, const FitScore& fit) {
  Proof proof;
  const auto squared = [](double x) { return x * x; };
  const double gain = squared(fit.heldoutBefore) - squared(fit.heldoutAfter);
  const double possible = squared(fit.heldoutBefore) - squared(fit.floor);
  if (possible > 0.0) proof.achieved = std::clamp(gain / possible, 0.0, 1.0);

  const auto block = [&](size_t w) {
    const Window& window = heldout[w];
    const Track& track = tracks[window.track];
    return Block{track.name, track.origin_s + track.time[window.first], window.track, std::sqrt(before[w]),
                 std::sqrt(after[w])};
  };
  if (!heldout.empty()) {
    std::vector<size_t> order(heldout.size());
    for (size_t w = 0; w < order.size(); ++w) order[w] = w;
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return after[a] < after[b]; });
    proof.worst = block(order.back());
    proof.typical = block(order[order.size() / 2]);
  }

  // What a window ends with grew from what the model lacks in that window alone: of a complete model this is white.
  std::vector<double> ends;
  Trace trace;
  for (size_t w = 0; w < heldout.size(); ++w) {
    const Window& window = heldout[w];
    const Track& track = tracks[window.track];
    const bool apart = w == 0 || heldout[w - 1].track != window.track || heldout[w - 1].last + 1 < window.first;
    if (window.errorIn == ErrorIn::torque) {
      if (apart) ends.insert(ends.end(), mostLags, std::nan(""));
      const Eigen::VectorXd left = TorqueResidual(track, window).of(best);
      ends.push_back(left[left.size() - 1]);
      continue;
    }
    const bool otherTrack = w == 0 || heldout[w - 1].track != window.track;
    if (otherTrack) trace = simulate(best, track, fit.window_s);
    if (apart) ends.insert(ends.end(), mostLags, std::nan(""));  // what lies apart isn't compared
    const double shown = track.speedAlone() ? trace.velocity[window.last] : trace.position[window.last];
    ends.push_back(track.seen[window.last] != 0 ? track.reading(window.last) - shown : std::nan(""));
  }
  const Whiteness whiteness = whitenessOf(ends);
  proof.lag1 = whiteness.lag1;
  proof.whitenessPValue = whiteness.pValue;
  return proof;
}

}  // namespace breakaway
