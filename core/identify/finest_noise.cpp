#include "identify/finest_noise.h"

#include <cmath>
#include <complex>
#include <numbers>

#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr size_t leastValues = 12;
constexpr double medianOfSquare = 0.4549364231;  // χ² with one degree of freedom

/// Around a turn by harmonics, whose powers are exponential; else by cosines of half turns, which bear ends that
/// differ.
double powerOf(const std::vector<double>& values, size_t order, bool around) {
  const auto n = static_cast<double>(values.size());
  const double step = (around ? 2.0 : 1.0) * std::numbers::pi * static_cast<double>(order) / n;
  std::complex<double> sum = 0.0;
  for (size_t k = 0; k < values.size(); ++k) sum += values[k] * std::polar(1.0, -step * (static_cast<double>(k) + 0.5));
  return around ? std::norm(sum) / (n * std::numbers::ln2) : sum.real() * sum.real() / (0.5 * n * medianOfSquare);
}

}  // namespace

double finestNoise(const std::vector<double>& values, bool around) {
  const size_t n = values.size();
  if (n < leastValues) return 0.0;
  const size_t orders = around ? (n + 1) / 2 : n;  // beyond them they repeat
  std::vector<double> powers;
  for (size_t order = orders / 3; order < orders; ++order) powers.push_back(powerOf(values, order, around));
  return std::sqrt(quantile(powers, 0.5));
}

}  // namespace breakaway
