#include "diagnose/fit/window.h"

#include <algorithm>
#include <limits>

#include "diagnose/simulate/simulator.h"

namespace breakaway {

namespace {

constexpr double surelyMoves = 8.0;  ///< standard deviations of a reading, from the least to the largest

}  // namespace

std::vector<Window> windowsOf(const std::vector<Track>& tracks, size_t track, size_t from, size_t to, double window_s) {
  std::vector<Window> windows;
  std::vector<size_t> starts = restartRows(tracks[track], window_s);
  const auto& time = tracks[track].time;
  // The last window counts only when it is nearly whole.
  if (time.back() - time[starts.back()] >= window_s * 0.9) starts.push_back(time.size());
  for (size_t k = 0; k + 1 < starts.size(); ++k) {
    if (starts[k] < from || starts[k + 1] > to || starts[k + 1] - starts[k] < 8) continue;
    windows.push_back({track, starts[k], starts[k + 1] - 1});
  }
  return windows;
}

bool moves(const Window& window, const std::vector<Track>& tracks) {
  const Track& track = tracks[window.track];
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (size_t row = window.first; row <= window.last; ++row) {
    if (!track.seen[row]) continue;
    least = std::min(least, track.reading(row));
    most = std::max(most, track.reading(row));
  }
  return most - least > surelyMoves * track.readingNoise();
}

}  // namespace breakaway
