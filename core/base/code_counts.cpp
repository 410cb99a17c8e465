#include "base/code_counts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace breakaway {

namespace {

constexpr size_t mostCodes = 64;
constexpr double manySteps = 0.8;                           // of scatter, beyond which steps hide nothing
constexpr double mostCounted = 1000.0;                      // samples that count as independent
constexpr double leastDifference = 1e-5;                    // of a value, or in its unit: below is rounding
constexpr int places = 400, sizes = 24;                     // of the posterior's grid
constexpr double smallestNoise = 0.04, largestNoise = 1.0;  // in steps

double below(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

struct Code {
  double place;  ///< in steps from the plain mean
  double count;
};

/// Of all codes, for a signal at `place` with noise `size`, both in steps.
double logLikelihood(const std::vector<Code>& codes, double place, double size) {
  double sum = 0.0;
  for (const Code& one : codes) {
    const double part = below((one.place + 0.5 - place) / size) - below((one.place - 0.5 - place) / size);
    sum += one.count * std::log(std::max(1e-300, part));
  }
  return sum;
}

/// Mean and standard error in steps.
Estimate posterior(const std::vector<Code>& codes) {
  std::vector<double> logs, at;
  for (int s = 0; s < sizes; ++s) {
    const double size = smallestNoise * std::pow(largestNoise / smallestNoise, s / (sizes - 1.0));
    for (int p = 0; p < places; ++p) {
      at.push_back((p + 0.5) / places - 0.5);
      logs.push_back(logLikelihood(codes, at.back(), size));
    }
  }
  const double most = *std::max_element(logs.begin(), logs.end());
  double weight = 0.0, sum = 0.0, squares = 0.0;
  for (size_t k = 0; k < logs.size(); ++k) {
    const double one = std::exp(logs[k] - most);
    weight += one, sum += one * at[k], squares += one * at[k] * at[k];
  }
  const double mean = sum / weight;
  return {mean, std::sqrt(std::max(0.0, squares / weight - mean * mean))};
}

}  // namespace

void CodeCounts::add(double value) {
  ++samples_;
  sum_ += value;
  squares_ += value * value;
  if (counts_.size() <= mostCodes) ++counts_[value];
}

Estimate CodeCounts::beyondMean(double step) const {
  const double middle = shownMean(), all = static_cast<double>(samples_);
  if (samples_ < 2) return {};
  const double scatter = std::sqrt(std::max(0.0, (squares_ - all * middle * middle) / (all - 1.0)));
  if (!(step > 0.0) || scatter > manySteps * step || counts_.size() > mostCodes) return {};
  std::map<long, double> byCode;
  const double first = counts_.begin()->first;
  for (const auto& [value, count] : counts_) byCode[std::lround((value - first) / step)] += static_cast<double>(count);
  std::vector<Code> codes;
  codes.reserve(byCode.size());
  for (const auto& [code, count] : byCode)
    codes.push_back({(first - middle) / step + static_cast<double>(code), count * std::min(1.0, mostCounted / all)});
  const Estimate inSteps = posterior(codes);
  return {step * inSteps.value, step * inSteps.standardError};
}

void SmallestStep::add(double value) {
  const double difference = std::abs(value - before_);
  const bool rounding = difference < leastDifference * std::max(1.0, std::abs(value));
  if (begun_ && !rounding && (step_ == 0.0 || difference < step_)) step_ = difference;
  before_ = value;
  begun_ = true;
}

}  // namespace breakaway
