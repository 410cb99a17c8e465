// A stretch of a recording as a recording of its own.
#pragma once

#include "base/result.h"
#include "recording/recording.h"

namespace breakaway {

/// The rows with from ≤ time ≤ to, with a note on what they are cut from. Errors: fewer than two rows.
Result<Recording> stretchOf(const Recording& recording, double from_s, double to_s);

}  // namespace breakaway
