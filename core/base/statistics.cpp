#include "base/statistics.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double rms(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0.0;
  const double at = fraction * static_cast<double>(values.size() - 1);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(
                                        std::lround(std::clamp(at, 0.0, static_cast<double>(values.size() - 1))));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

double upperBound95(size_t hits, size_t runs) {
  if (hits >= runs) return 1.0;
  const auto n = static_cast<double>(runs);
  // P(X ≤ hits) of the binomial distribution falls with p.
  const auto atMost = [&](double p) {
    double term = n * std::log1p(-p), sum = std::exp(term);
    for (size_t k = 0; k < hits; ++k) {
      const auto i = static_cast<double>(k);
      term += std::log((n - i) / (i + 1.0)) + std::log(p) - std::log1p(-p);
      sum += std::exp(term);
    }
    return sum;
  };
  double low = 0.0, high = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (atMost(middle) > 0.05 ? low : high) = middle;
  }
  return high;
}

}  // namespace breakaway
