#include "diagnose/fit/split.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "diagnose/fit/channel_checks.h"
#include "diagnose/fit/torque_residual.h"

namespace breakaway {

namespace {

constexpr double gap_s = 1.0;
constexpr size_t fewestWindows = 6;
constexpr size_t mostTrainRows = 90'000, fewestThinned = 60;
constexpr double comfortableWindows = 9.0;  ///< the first is lost, and those with missing rows
constexpr size_t fewestWindowRows = 12;     ///< of a window
constexpr size_t fewestInTorque = 8;        ///< instants of a window
constexpr double shortestWindow_s = 0.04;
constexpr double lookBack_s = 0.2;  ///< before a window, which a restart reads
constexpr double longestUnread_s = 0.1;

struct Stretch {
  double from = 0.0;
  double to = 0.0;
};

size_t rowAt(const Track& track, double t) {
  return static_cast<size_t>(std::lower_bound(track.time.begin(), track.time.end(), t - 1e-9) - track.time.begin());
}

void append(std::vector<Window>& to, std::vector<Window> from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Held-out stretches of one recording of `length` s: a fifth of each part of about 30 s.
std::vector<Stretch> heldoutStretches(double length, HeldOut part) {
  const double parts = std::clamp(std::round(length / 30.0), 1.0, 8.0);
  std::vector<Stretch> stretches;
  for (double k = 1.0; k <= parts; k += 1.0) {
    const bool middle = part == HeldOut::middle;
    const double to = (middle ? k - 0.4 : k) * length / parts;
    const double from = std::round(to - std::max(1.0, 0.2 * length / parts));
    stretches.push_back({from, k < parts || middle ? std::floor(to) : length + 1.0});
  }
  return stretches;
}

double totalTime(const std::vector<Track>& tracks, size_t recordings) {
  double total = 0.0;
  for (size_t k = 0; k < recordings; ++k) total += tracks[k].time.back();
  return total;
}

Error tooShort(const Track& track, double length, double needed, size_t windows, double window_s) {
  if (length >= needed) {
    return {track.name,
            fmt::format(
                "holds {} windows of {:.3g} s in which no row is missing, expected at least {}; the usual step from "
                "row to row is {:.3g} s",
                windows, window_s, fewestWindows, track.usualStep_s)};
  }
  return {track.name, fmt::format("is too short to fit: it holds {:.3g} s of usable data, expected at least {:.3g} s",
                                  length, needed)};
}

/// Windows of `window_s` that begin every half of it within rows [from, to). A pause costs one step, however long it
/// is.
void appendOverlapping(std::vector<Window>& windows, const Track& track, size_t index, size_t from, size_t to,
                       double window_s) {
  if (from >= to) return;
  const double end = to < track.rows() ? track.time[to] : track.time.back();
  const double step_s = 0.5 * window_s;
  double t = track.time[from], next = t;
  for (; t + window_s <= end + 1e-9; t = next) {
    const size_t first = rowAt(track, t), past = std::min(rowAt(track, t + window_s), to);
    if (first >= to) return;
    if (past > first + 8) windows.push_back({index, first, past - 1});  // within a gap there is none
    next = t + step_s;
    if (past == first) next = t + step_s * std::max(1.0, std::floor((track.time[first] - t) / step_s) - 2.0);
    if (next <= t) return;  // stamps so large that a window is none of their digits
  }
}

/// The first row that a window's restart looks at, or one before.
size_t lookedBackTo(const Window& window, const Track& track) {
  size_t row = window.first;
  while (row > 0 && track.time[window.first] - track.time[row - 1] < lookBack_s) --row;
  return row;
}

/// Leaves out windows with a missing row, in which a restless drive may have done anything, where most have none.
/// What it did before a window begins is in its first speed and current.
void preferComplete(std::vector<Window>& windows, const std::vector<Track>& tracks) {
  std::vector<Window> complete;
  std::copy_if(windows.begin(), windows.end(), std::back_inserter(complete), [&tracks](const Window& window) {
    const Track& track = tracks[window.track];
    for (size_t row = lookedBackTo(window, track); row < window.last; ++row) {
      if (track.missingInput(row) > 0.0) return false;
    }
    return true;
  });
  if (2 * complete.size() > windows.size()) windows = std::move(complete);
}

/// Before a recording's first row nothing is known, its speed least of all, and nobody knows what acted while rows are
/// missing, nor what the axis did while no position was read: windows that begin or run there tell no model's worth.
void dropUnknown(Split& split, const std::vector<Track>& tracks) {
  const auto unknown = [&](const Window& window) {
    if (window.first == 0) return true;
    const Track& track = tracks[window.track];
    size_t row = lookedBackTo(window, track);
    double read_s = track.time[row];
    for (row -= row > 0 ? 1 : 0; row < window.last; ++row) {
      if (isGap(track.time[row + 1] - track.time[row], track.usualStep_s)) return true;
      if (std::binary_search(track.leaps.begin(), track.leaps.end(), row)) return true;
      if (track.placed(row)) read_s = track.time[row];
      if (track.time[row + 1] - read_s > longestUnread_s) return true;
    }
    return false;
  };
  for (auto* windows : {&split.train, &split.polish, &split.trainScore, &split.heldoutScore}) {
    std::erase_if(*windows, unknown);
    preferComplete(*windows, tracks);
  }
}

/// Evenly spread windows with at most `rows` rows in all, but not fewer than `fewest`: what is known well enough need
/// not be fitted for ever.
void thin(std::vector<Window>& windows, size_t rows, size_t fewest) {
  size_t all = 0;
  for (const Window& window : windows) all += window.last - window.first + 1;
  if (all <= rows || windows.size() <= fewest) return;
  const size_t keep = std::max(fewest, windows.size() * rows / all);
  std::vector<Window> kept;
  kept.reserve(keep);
  for (size_t k = 0; k < keep; ++k) kept.push_back(windows[k * windows.size() / keep]);
  windows = std::move(kept);
}

/// Errors in torque are known in clear motion only.
void countErrorsIn(ErrorIn errorIn, Split& split, const std::vector<Track>& tracks) {
  if (errorIn == ErrorIn::motion) return;
  for (auto* windows : {&split.train, &split.polish, &split.trainScore, &split.heldoutScore}) {
    for (Window& window : *windows) window.errorIn = errorIn;
    std::erase_if(*windows, [&tracks](const Window& window) {
      return !isLongEnough(tracks[window.track], window, fewestInTorque);
    });
  }
}

void thinTraining(Split& split) {
  thin(split.train, mostTrainRows, fewestThinned);
  thin(split.polish, 2 * mostTrainRows, 2 * fewestThinned);
}

void assignFolds(Split& split) {
  const size_t n = split.train.size();
  const size_t length = std::max<size_t>(1, n / (3 * static_cast<size_t>(folds)));
  for (size_t k = 0; k < n; ++k) split.fold.push_back(static_cast<int>(k / length) % folds);
}

/// Fits see longer windows than the figures where there is enough to see.
double fitLength(double total, double window_s) {
  return total >= 15.0 ? std::max(std::min(1.0, 2.0 * window_s), window_s) : window_s;
}

Result<Split> wholeTracks(const std::vector<Track>& tracks, double longest_s, ErrorIn errorIn) {
  Split split;
  const double total = totalTime(tracks, tracks.size());
  const double shortest_s =
      std::max(static_cast<double>(fewestWindowRows) * tracks.front().usualStep_s, shortestWindow_s);
  const double window_s = std::clamp(total / comfortableWindows, std::min(shortest_s, longest_s), longest_s);
  split.window_s = window_s;
  const double fitWindow = fitLength(total, window_s);
  for (size_t k = 0; k < tracks.size(); ++k) {
    append(split.train, windowsOf(tracks, k, 0, tracks[k].rows(), fitWindow));
    appendOverlapping(split.polish, tracks[k], k, 0, tracks[k].rows(), fitWindow);
    append(split.trainScore, windowsOf(tracks, k, 0, tracks[k].rows(), window_s));
  }
  dropUnknown(split, tracks);
  countErrorsIn(errorIn, split, tracks);
  if (split.train.size() < fewestWindows)
    return tooShort(tracks.front(), total, comfortableWindows * fitWindow, split.train.size(), fitWindow);
  thinTraining(split);
  assignFolds(split);
  return split;
}

/// Training and held-out windows, the fit's of `fitWindow` s.
Split partedTracks(const std::vector<Track>& tracks, size_t recordings, double window_s, double fitWindow, HeldOut part,
                   ErrorIn errorIn) {
  Split split;
  split.window_s = window_s;
  split.separateRecording = recordings < tracks.size();
  const double total = totalTime(tracks, recordings);
  const bool wholeOnes = !split.separateRecording && recordings >= 4 && total / static_cast<double>(recordings) < 8.0;
  for (size_t k = 0; k < tracks.size(); ++k) {
    const Track& track = tracks[k];
    const bool heldout = k >= recordings || (wholeOnes && k % 4 == 2);
    if (heldout) {
      append(split.heldoutScore, windowsOf(tracks, k, 0, track.rows(), window_s));
      continue;
    }
    const auto train = [&](size_t from, size_t to) {
      append(split.train, windowsOf(tracks, k, from, to, fitWindow));
      appendOverlapping(split.polish, track, k, from, to, fitWindow);
      append(split.trainScore, windowsOf(tracks, k, from, to, window_s));
    };
    if (split.separateRecording || wholeOnes) {
      train(0, track.rows());
      continue;
    }
    split.blocks = true;
    double from = 0.0;
    for (const Stretch& stretch : heldoutStretches(track.time.back(), part)) {
      train(from > 0.0 ? rowAt(track, from) : 0, rowAt(track, stretch.from - gap_s));
      append(split.heldoutScore, windowsOf(tracks, k, rowAt(track, stretch.from), rowAt(track, stretch.to), window_s));
      if (k == 0) split.heldoutRows.emplace_back(rowAt(track, stretch.from), rowAt(track, stretch.to));
      from = stretch.to + gap_s;
    }
    if (from < track.time.back()) train(rowAt(track, from), track.rows());
  }
  dropUnknown(split, tracks);
  countErrorsIn(errorIn, split, tracks);
  return split;
}

}  // namespace

Result<Split> splitTracks(const std::vector<Track>& tracks, size_t recordings, double window_s, HeldOut part,
                          ErrorIn errorIn) {
  if (part == HeldOut::none) return wholeTracks(tracks, window_s, errorIn);
  const double total = totalTime(tracks, recordings);
  double fitWindow = fitLength(total, window_s);
  Split split = partedTracks(tracks, recordings, window_s, fitWindow, part, errorIn);
  if (split.train.size() < fewestWindows && fitWindow > window_s) {  // many short recordings, or rows missing often
    fitWindow = window_s;
    split = partedTracks(tracks, recordings, window_s, fitWindow, part, errorIn);
  }
  const double needed = (static_cast<double>(fewestWindows) * fitWindow + gap_s) / 0.8;
  if (split.train.size() < fewestWindows || split.heldoutScore.size() < 2)
    return tooShort(tracks.front(), total, needed, split.train.size(), fitWindow);
  if (std::none_of(split.heldoutScore.begin(), split.heldoutScore.end(),
                   [&tracks](const Window& window) { return moves(window, tracks); }))
    return Error{tracks.front().name, message("stands still in all of what is kept for the proof")};
  thinTraining(split);
  assignFolds(split);
  return split;
}

}  // namespace breakaway
