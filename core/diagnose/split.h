// Which windows train, and which prove: locked before anything is fitted.
#pragma once

#include <utility>
#include <vector>

#include "base/result.h"
#include "diagnose/fit/window_residual.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

struct Split {
  std::vector<Window> train;   ///< what the search fits
  std::vector<Window> polish;  ///< the same rows in overlapping windows, four times as many: what the final fits see
  std::vector<int> fold;  ///< 0 … folds − 1, one per training window, in stretches: for cross-validated choices
  std::vector<Window> trainScore;  ///< windows of window_s for the figures
  std::vector<Window> heldoutScore;
  std::vector<std::pair<size_t, size_t>> heldoutRows;  ///< [first, last + 1) of the first recording
  bool separateRecording = false;
};

constexpr int folds = 4;

/// The first `recordings` tracks train; the others, if any, are held out. Without others, blocks of the recordings
/// themselves are held out, a fifth of the time, at least 1 s away from any training sample; of four or more recordings
/// too short for that, every fourth is held out as a whole. Training windows last 1 s when there are 15 s or more, else
/// window_s. Errors: too short to fit.
Result<Split> splitTracks(const std::vector<Track>& tracks, size_t recordings, double window_s);

/// All of the tracks as training windows, for fits without a proof.
Result<Split> wholeTracks(const std::vector<Track>& tracks, double window_s);

}  // namespace breakaway
