// How good a recording's channels are, before anything is fitted.
#pragma once

#include <string>
#include <vector>

#include "diagnose/simulate/track.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// Figures of one recording. On a linear axis read m for rad and N for Nm; of a recording of speed alone readings are
/// rad/s.
struct ChannelQuality {
  std::string recording;
  size_t rows = 0;
  double duration_s = 0.0;
  double rate_Hz = 0.0;         ///< by the median step
  double jitter_s = 0.0;        ///< median distance of steps from the usual one
  size_t missingRows = 0;       ///< by the length of steps
  double longestGap_s = 0.0;    ///< longest step
  double repeatedPart = 0.0;    ///< of the rows while it moves: nothing that was measured differs from the row before
  double unreadPart = 0.0;      ///< of the rows, without a position
  double readingStep = 0.0;     ///< smallest difference of two readings, rad; 0: none is seen
  double declaredCount = 0.0;   ///< of the bench, rad; 0: none
  double readingNoise = 0.0;    ///< standard deviation of one reading, rad
  double currentNoise_A = 0.0;  ///< the same of a recorded current; 0: none
  double restPart = 0.0;        ///< of the time, standing still
  double forwardsPart = 0.0;    ///< of the motion, towards growing position
  size_t reversals = 0;
  double travel = 0.0;   ///< from the lowest to the highest position, rad
  double fastest = 0.0;  ///< 99 % quantile of |velocity|, rad/s
  std::string driveColumn;
  double drivePeak = 0.0;      ///< largest |drive|: V, A or Nm
  double atLimitPart = 0.0;    ///< of the rows, at exactly the drive's largest or smallest value
  bool driveReverses = false;  ///< a twentieth of the rows or more each way
};

/// `track` is of readTrack().
ChannelQuality qualityOf(const Bench& bench, const Recording& recording, const Track& track);

/// The figures in sentences: what the recording is first, then what is wrong or poor, each with what it costs.
std::vector<std::string> inWords(const ChannelQuality& quality, const Bench& bench);

}  // namespace breakaway
