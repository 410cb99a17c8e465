#include "draw/svg_ticks.h"

#include <fmt/core.h>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/typeset.h"

namespace breakaway {

namespace {

const char* const minus = "\u2212";

std::string fixed(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  return (value < 0 && text.find_first_not_of("0.") != std::string::npos ? minus : "") + text;
}

}  // namespace

std::vector<double> niceTicks(double low, double high, int count) {
  assert(low < high);
  const double rough = (high - low) / std::max(1, count);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double rest = rough / power;
  const double step = (rest < 1.5 ? 1.0 : rest < 3.5 ? 2.0 : rest < 7.5 ? 5.0 : 10.0) * power;
  const double slack = 1e-9 * step;
  std::vector<double> ticks;
  for (double n = std::ceil((low - slack) / step); n * step <= high + slack && ticks.size() < 100; n += 1.0) {
    ticks.push_back(n == 0.0 ? 0.0 : n * step);
  }
  return ticks;
}

std::vector<double> decadeTicks(double low, double high, int count) {
  assert(low > 0.0 && low < high);
  const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
  std::vector<double> ticks;
  if (last - first + 1 >= 2) {
    const int stride = std::max(1, (last - first + count) / std::max(1, count));
    for (int n = first; n <= last; n += stride) ticks.push_back(std::pow(10.0, n));
    return ticks;
  }
  for (int n = first - 1; n <= last + 1; ++n) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, n);
      if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) ticks.push_back(value);
    }
  }
  return ticks.size() >= 2 ? ticks : niceTicks(low, high, count);
}

TickLabels tickLabels(const std::vector<double>& ticks) {
  TickLabels labels;
  if (ticks.empty()) return labels;
  double largest = 0.0;
  for (const double tick : ticks) largest = std::max(largest, std::abs(tick));
  if (largest > 0.0 && (largest < 1e-2 || largest >= 1e5)) {
    labels.exponent = 3 * static_cast<int>(std::floor(std::log10(largest * (1 + 1e-9)) / 3.0));
  }
  const double scale = std::pow(10.0, -labels.exponent);
  double step = largest * scale;
  for (size_t k = 1; k < ticks.size(); ++k) step = std::min(step, (ticks[k] - ticks[k - 1]) * scale);
  int decimals = 0;
  while (decimals < 12 && step > 0.0 && std::abs(step - std::round(step)) > 1e-6 * step) {
    step *= 10.0;
    ++decimals;
  }
  if (step == 0.0) decimals = 0;
  for (const double tick : ticks) labels.texts.push_back(fixed(tick * scale, decimals));
  return labels;
}

std::string decadeLabel(double value) {
  const double exponent = std::log10(value);
  const int whole = static_cast<int>(std::lround(exponent));
  if (std::abs(exponent - whole) < 1e-9 && (whole < -1 || whole > 2)) return "10" + superscript(whole);
  return fmt::format("{:g}", value);
}

std::string exponentText(int exponent) {
  return exponent == 0 ? "" : " (× 10" + superscript(exponent) + ")";
}

}  // namespace breakaway
