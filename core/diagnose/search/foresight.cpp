#include "diagnose/search/foresight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/statistics.h"
#include "diagnose/fit/noise_floor.h"

namespace breakaway {

namespace {

constexpr size_t mostLooked = 60;    ///< windows
constexpr size_t fewestRows = 10;    ///< of a window
constexpr double shorter = 0.7;      ///< from one length tried to the next
constexpr double shortest_s = 0.02;  ///< of a window

/// Of windows of the split evenly spread, the first `length_s`.
std::vector<Window> beginnings(const SearchInput& input, double length_s) {
  const auto& whole = input.split.trainScore;
  const size_t keep = std::min(mostLooked, whole.size());
  std::vector<Window> windows;
  for (size_t k = 0; k < keep; ++k) {
    Window window = whole[k * whole.size() / keep];
    const auto& time = input.tracks[window.track].time;
    const double end = time[window.first] + length_s + 1e-9;
    while (window.last > window.first && time[window.last] > end) --window.last;
    if (window.last - window.first + 1 >= fewestRows) windows.push_back(window);
  }
  return windows;
}

/// The rms error, the worst windows included, of a perfect model beside that of `base`.
double perfectBeside(const SearchInput& input, const Model& base, const Model& proposed, double length_s) {
  const auto windows = beginnings(input, length_s);
  if (windows.empty()) return HUGE_VAL;
  const double errs = mean(scoreWindows(base, input.tracks, windows));
  return errs > 0.0 ? std::sqrt(mean(usualSquares(proposed, input.tracks, windows, input.seed, {})) / errs) : HUGE_VAL;
}

}  // namespace

double foreseeable(const SearchInput& input, const Model& base, const Model& proposed) {
  double best_s = input.split.window_s, best = perfectBeside(input, base, proposed, best_s);
  if (best < 1.0) return best_s;
  for (double length_s = shorter * best_s; length_s >= shortest_s; length_s *= shorter) {
    const double ratio = perfectBeside(input, base, proposed, length_s);
    if (ratio < best) {
      best = ratio;
      best_s = length_s;
    }
  }
  return best < 1.0 ? best_s : input.split.window_s;
}

}  // namespace breakaway
