// What a recording's channels say of themselves before any model looks at them.
#pragma once

#include <string>
#include <vector>

#include "diagnose/model/criteria.h"
#include "diagnose/simulate/track.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// Whether a step is so much longer than the usual one that what acted meanwhile is not known.
bool isGap(double step_s, double usual_s);

/// Rows after which the position leaps by what no axis moves from row to row: 20 times what this one usually does.
std::vector<size_t> leapsOf(const Track& track);

/// An error where all leaps are whole turns: the angle starts anew at each.
Result<void> checkUnwrapped(const Bench& bench, const Track& track);

/// Sentences on rows that are missing, positions that leap, a drive that is clipped or never changes, a velocity that
/// contradicts the angle, and a drive that contradicts the motion. `track` carries its leaps and its smoothed motion.
std::vector<std::string> channelRemarks(const Bench& bench, const Recording& recording, const Track& track,
                                        const Criteria& criteria = {});

}  // namespace breakaway
