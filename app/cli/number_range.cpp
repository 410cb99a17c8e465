#include "cli/number_range.h"

#include <fmt/format.h>

#include <string>

namespace breakaway::cli {

CLI::Validator numberIn(double low, double high) {
  const auto check = [low, high](std::string& text) {
    double value = 0.0;
    const bool isOne = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
    return isOne ? std::string() : fmt::format("is {}, expected a number from {:g} to {:g}", text, low, high);
  };
  return {check, fmt::format("in [{:g} - {:g}]", low, high)};
}

}  // namespace breakaway::cli
