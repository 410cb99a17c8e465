// One speed's strokes as a file of an interrupted commissioning's progress.
#pragma once

#include <string>

#include "base/result.h"
#include "friction/measurements.h"

namespace breakaway {

/// progress/strokes-NN.json in `folder`, counted from 1; of a run that was broken off strokes-NN-broken-off.json.
std::string strokesFile(const std::string& folder, size_t number, bool brokenOff = false);
Result<void> writeStrokes(const TravelRun& run, const std::string& path);
/// Errors: a field is missing or wrong, by file and name.
Result<TravelRun> readStrokes(const std::string& path);

}  // namespace breakaway
