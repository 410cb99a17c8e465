// One recording as a track with its smoothed motion.
#pragma once

#include "base/result.h"
#include "diagnose/simulate/track.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// The track that the bench needs, its leaps found, readings that are near bridged, its motion smoothed. Errors: a
/// column is missing or has no value, the angle wraps.
Result<Track> readTrack(const Bench& bench, const Recording& recording);

}  // namespace breakaway
