// Where an axis has its ticks and what they say.
#pragma once

#include <string>
#include <vector>

namespace breakaway {

/// Multiples of 1, 2 or 5 × 10ⁿ within [low, high], about `count` of them. Needs low < high, both finite.
std::vector<double> niceTicks(double low, double high, int count);

/// Powers of ten within [low, high], thinned to about `count`; where the range holds fewer than two, 1-2-5 steps. Needs
/// 0 < low < high.
std::vector<double> decadeTicks(double low, double high, int count);

struct TickLabels {
  std::vector<std::string> texts;
  int exponent = 0;  ///< the texts are to be read × 10^exponent; a multiple of 3
};

/// The shortest texts that tell the ticks apart, with a true minus sign, very large or small values with a common
/// exponent.
TickLabels tickLabels(const std::vector<double>& ticks);
/// A power of ten as "10⁻³"; 0.1, 1, 10 and 100, and what is no power of ten, in plain digits.
std::string decadeLabel(double value);
/// " (× 10⁻⁶)", or nothing for 0.
std::string exponentText(int exponent);

}  // namespace breakaway
