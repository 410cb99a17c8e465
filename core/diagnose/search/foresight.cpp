#include "diagnose/search/foresight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/statistics.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr size_t mostLooked = 60;      ///< windows
constexpr size_t fewestRows = 10;      ///< of a window
constexpr double runAwayFactor = 5.0;  ///< more than a torque constant may be off by

/// Of the split's windows, evenly spread.
std::vector<Window> someWindows(const SearchInput& input) {
  const auto& whole = input.split.trainScore;
  const size_t keep = std::min(mostLooked, whole.size());
  std::vector<Window> windows;
  for (size_t k = 0; k < keep; ++k) {
    const Window& window = whole[k * whole.size() / keep];
    if (window.last - window.first + 1 >= fewestRows) windows.push_back(window);
  }
  return windows;
}

}  // namespace

bool isForeseeable(const SearchInput& input, const Model& base, const Model& proposed) {
  const auto windows = someWindows(input);
  return windows.empty() || mean(usualSquares(proposed, input.tracks, windows, input.seed, {})) <
                                mean(scoreWindows(base, input.tracks, windows));
}

std::optional<double> runAway(const Model& base, const Model& inverse) {
  if (base.servo || base.pendulum || physicsOf(base).electrical) return std::nullopt;
  const std::string name = motorNames(base.axis).inertia;
  for (const Parameter& one : inverse.base) {
    const bool shown = one.name == name && one.low95 > 0.0 && one.low95 < one.value;
    const double ratio = shown ? base.baseValue(name).value_or(one.value) / one.value : 1.0;
    if (ratio > runAwayFactor || ratio < 1.0 / runAwayFactor) return ratio;
  }
  return std::nullopt;
}

}  // namespace breakaway
