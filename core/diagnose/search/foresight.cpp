#include "diagnose/search/foresight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/statistics.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr size_t mostLooked = 60;    ///< windows
constexpr size_t fewestRows = 10;    ///< of a window
constexpr double shorter = 0.7;      ///< from one length tried to the next
constexpr double shortest_s = 0.02;  ///< of a window

/// Of windows of the split evenly spread, the first part.
std::vector<Window> beginnings(const SearchInput& input, const Counting& counting) {
  const auto& whole = input.split.trainScore;
  const size_t keep = std::min(mostLooked, whole.size());
  std::vector<Window> windows;
  for (size_t k = 0; k < keep; ++k) {
    Window window = whole[k * whole.size() / keep];
    const Track& track = input.tracks[window.track];
    const double end = track.time[window.first] + counting.window_s + 1e-9;
    while (window.last > window.first && track.time[window.last] > end) --window.last;
    window.errorIn = counting.errorIn;
    if (isLongEnough(track, window, fewestRows)) windows.push_back(window);
  }
  return windows;
}

/// The rms error, the worst windows included, of a perfect model beside that of `base`.
double perfectBeside(const SearchInput& input, const Model& base, const Model& proposed, const Counting& counting) {
  const auto windows = beginnings(input, counting);
  if (windows.empty()) return HUGE_VAL;
  const double errs = mean(scoreWindows(base, input.tracks, windows));
  return errs > 0.0 ? std::sqrt(mean(usualSquares(proposed, input.tracks, windows, input.seed, {})) / errs) : HUGE_VAL;
}

}  // namespace

std::optional<Counting> betterCounting(const SearchInput& input, const Model& base, const Model& proposed) {
  const double window_s = input.split.window_s;
  double least = perfectBeside(input, base, proposed, {ErrorIn::motion, window_s});
  if (least < 1.0) return std::nullopt;
  std::vector<Counting> others;
  if (input.mayTurnToTorque) others.push_back({ErrorIn::torque, window_s});
  for (double length_s = shorter * window_s; length_s >= shortest_s; length_s *= shorter)
    others.push_back({ErrorIn::motion, length_s});
  std::optional<Counting> best;
  for (const Counting& one : others) {
    const double ratio = perfectBeside(input, base, proposed, one);
    if (ratio >= least) continue;
    least = ratio;
    best = one;
  }
  return least < 1.0 ? best : std::nullopt;
}

std::optional<double> runAway(const Model& base, const Model& inverse, const Criteria& criteria) {
  if (base.servo || base.pendulum || physicsOf(base).electrical) return std::nullopt;
  const std::string name = motorNames(base.axis).inertia;
  for (const Parameter& one : inverse.base) {
    const bool shown = one.name == name && one.low95 > 0.0 && one.low95 < one.value;
    const double ratio = shown ? base.baseValue(name).value_or(one.value) / one.value : 1.0;
    if (ratio > criteria.runAway || ratio < 1.0 / criteria.runAway) return ratio;
  }
  return std::nullopt;
}

}  // namespace breakaway
