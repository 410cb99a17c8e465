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

}  // namespace breakaway
