// What an interrupted commissioning has already, as files: enough to go on where it ended.
#pragma once

#include <string>

#include "base/result.h"
#include "commission/known.h"

namespace breakaway {

/// The motor once it is identified, runs or strokes, and breakaways: everything that isn't computed from these, or lost
/// with the board's power. Writes progress/state.json, progress/run-NN.json, progress/strokes-NN.json and
/// progress/breakaways.json into `folder`. Runs never change, so those that are there are not written again.
Result<void> writeProgress(const Commission& progress, const std::string& folder);

/// What writeProgress() wrote. Errors: there is none, or a field is missing or wrong, by file and name.
Result<Commission> readProgress(const std::string& folder);

/// Whether there is something to go on from.
bool holdsProgress(const std::string& folder);

/// Removes what writeProgress() wrote; nothing there is fine.
Result<void> removeProgress(const std::string& folder);

}  // namespace breakaway
