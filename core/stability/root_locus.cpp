#include "stability/root_locus.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace breakaway {

namespace {

constexpr double wantedDamping = 0.707;
constexpr size_t locusSteps = 160;

/// The present poles in the order of the branches' ends.
std::vector<std::complex<double>> joined(const std::vector<std::complex<double>>& ends,
                                         std::vector<std::complex<double>> present) {
  std::vector<std::complex<double>> ordered(ends.size());
  std::vector<bool> open(ends.size(), true);
  for (size_t round = 0; round < ends.size(); ++round) {
    size_t branch = 0, pole = 0;
    double nearest = HUGE_VAL;
    for (size_t b = 0; b < ends.size(); ++b) {
      if (!open[b]) continue;
      for (size_t p = 0; p < present.size(); ++p) {
        const double distance = std::abs(ends[b] - present[p]);
        if (distance < nearest) nearest = distance, branch = b, pole = p;
      }
    }
    open[branch] = false;
    ordered[branch] = present[pole];
    present.erase(present.begin() + static_cast<std::ptrdiff_t>(pole));
  }
  return ordered;
}

/// The first cutoff at which `good` turns false, refined by bisection; nothing when it never does.
std::optional<double> firstLoss(const std::vector<double>& cutoffs, const std::function<bool(double)>& good) {
  for (size_t k = 1; k < cutoffs.size(); ++k) {
    if (good(cutoffs[k])) continue;
    double low = cutoffs[k - 1], high = cutoffs[k];
    while (high > low * (1.0 + 1e-9)) {
      const double middle = std::sqrt(low * high);
      (good(middle) ? low : high) = middle;
    }
    return std::sqrt(low * high);
  }
  return {};
}

}  // namespace

std::vector<double> decades(double low, double high, size_t count) {
  std::vector<double> values(count);
  for (size_t k = 0; k < count; ++k)
    values[k] = low * std::pow(high / low, static_cast<double>(k) / static_cast<double>(count - 1));
  return values;
}

ServoLoop withCutoff(ServoLoop loop, double cutoff_rad_per_s) {
  loop.settings.observer_cutoff_rad_per_s = cutoff_rad_per_s;
  return loop;
}

RootLocus rootLocus(const ServoLoop& loop, const std::vector<double>& cutoffs_rad_per_s) {
  RootLocus locus;
  locus.cutoff_rad_per_s = cutoffs_rad_per_s;
  std::vector<std::complex<double>> ends;
  for (const double cutoff : cutoffs_rad_per_s) {
    auto present = poles(closedLoop(withCutoff(loop, cutoff)));
    ends = ends.empty() ? present : joined(ends, std::move(present));
    locus.branches.resize(ends.size());
    for (size_t b = 0; b < ends.size(); ++b) locus.branches[b].push_back(ends[b]);
  }
  return locus;
}

CutoffBounds cutoffBounds(const ServoLoop& loop) {
  const double T = loop.board.tick_s;
  CutoffBounds bounds;
  bounds.searched_rad_per_s = 10.0 / T;
  const auto cutoffs = decades(1e-4 / T, bounds.searched_rad_per_s, locusSteps);
  const auto stable = [&loop](double g) { return spectralRadius(closedLoop(withCutoff(loop, g))) < 1.0; };
  const auto damped = [&loop](double g) { return damping(poles(closedLoop(withCutoff(loop, g)))) >= wantedDamping; };
  bounds.stableBelow = stable(cutoffs.front());
  bounds.dampedBelow = damped(cutoffs.front());
  if (bounds.stableBelow) bounds.unstable_rad_per_s = firstLoss(cutoffs, stable);
  if (bounds.dampedBelow) bounds.lessDamped_rad_per_s = firstLoss(cutoffs, damped);
  bounds.ruleOfThumb_rad_per_s = 0.3 / (loop.alpha() * T);
  if (loop.speed == SpeedSource::observer)
    bounds.filterRule_rad_per_s = 0.5 * loop.board.velocityBandwidth_rad_per_s / loop.alpha();
  return bounds;
}

}  // namespace breakaway
