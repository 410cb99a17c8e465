// Recordings that hold the same rows: nothing can be proved on what was learned from.
#pragma once

#include <vector>

#include "base/result.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// Whether any two of the recordings, in any list, share a stretch of rows: equal positions (or speeds) and drive over
/// at least 100 rows and a twentieth of the shortest recording, of which a quarter change otherwise than the row
/// before, which no second measurement repeats. Times don't matter. The error names both recordings and the row with
/// which the stretch begins.
Result<void> checkSharedRows(const Bench& bench, const std::vector<Recording>& recordings,
                             const std::vector<Recording>& heldout);

}  // namespace breakaway
