// Two recordings laid over each other from their beginnings: what each channel does in both.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "draw/svg_plot.h"
#include "recording/recording.h"

namespace breakaway {

/// A channel of columns.h that both recordings hold, over the time that both last. SI, as the channel's name says.
struct ChannelChange {
  std::string channel;
  double meanBefore = 0.0, meanAfter = 0.0;  ///< of a position less its first value: encoders begin anywhere
  double rmsBefore = 0.0, rmsAfter = 0.0;    ///< about the mean
  double differenceRms = 0.0;                ///< of after − before at the same time since the beginning
};

struct RecordingComparison {
  double length_s = 0.0;  ///< that both last
  std::vector<ChannelChange> channels;
  std::vector<Figure> figures;  ///< one a channel, over the time since the beginning; the earlier one dashed
};

/// What stands between rows lies on a straight line; rows without a value count nowhere. No channel where they hold
/// none in common, or fewer than two rows.
RecordingComparison compareRecordings(const Recording& before, const Recording& after);

/// "current_A: mean 0.21 → 0.24, scatter 0.3 → 0.33; laid over each other they differ by 0.05 (RMS)."
Message sentenceOf(const ChannelChange& change);

}  // namespace breakaway
