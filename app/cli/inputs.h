// What several commands read from their line.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway::cli {

/// Reads every recording; the first that can't be read is the error.
Result<std::vector<Recording>> readRecordings(const std::vector<std::string>& paths);

/// True when a person watches standard error.
bool progressIsWatched();

}  // namespace breakaway::cli
