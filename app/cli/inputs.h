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

/// What a diagnosis runs on.
struct DiagnosisInputs {
  Bench bench;
  std::vector<Recording> recordings, heldout;
};

/// Reads all of them; the first that can't be read is the error.
Result<DiagnosisInputs> readDiagnosisInputs(const std::string& bench, const std::vector<std::string>& recordings,
                                            const std::vector<std::string>& heldout);

/// True when a person watches standard error.
bool progressIsWatched();

}  // namespace breakaway::cli
