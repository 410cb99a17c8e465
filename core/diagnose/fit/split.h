// Which windows train, and which prove: locked before anything is fitted.
#pragma once

#include <utility>
#include <vector>

#include "base/result.h"
#include "diagnose/fit/window.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

struct Split {
  std::vector<Window> train;   ///< what the search fits
  std::vector<Window> polish;  ///< the same rows in overlapping windows, four times as many: what the final fits see
  std::vector<int> fold;  ///< 0 … folds − 1, one per training window, in stretches: for cross-validated choices
  double window_s = 0.5;
  std::vector<Window> trainScore;  ///< windows of window_s for the figures
  std::vector<Window> heldoutScore;
  std::vector<std::pair<size_t, size_t>> heldoutRows;  ///< [first, last + 1) of the first recording
  bool separateRecording = false;
  bool blocks = false;  ///< held out are parts of the recordings that train
};

constexpr int folds = 4;

/// Which fifth of each half minute of the recordings themselves is held out.
enum class HeldOut { none, last, middle };

/// The first `recordings` tracks train; the others, if any, are held out. Without others, blocks of the recordings
/// themselves are held out, a fifth of the time, at least 1 s away from any training sample; of four or more recordings
/// too short for that, every fourth is held out as a whole. With HeldOut::none all tracks train, for fits without a
/// proof. Training windows last twice window_s, up to 1 s, when there are 15 s or more, else window_s; where all
/// trains, all windows are as short as nine of them need. Errors: too short to fit.
Result<Split> splitTracks(const std::vector<Track>& tracks, size_t recordings, double window_s,
                          HeldOut part = HeldOut::last, ErrorIn errorIn = ErrorIn::motion);

}  // namespace breakaway
