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

/// True when a person watches standard error, and didn't ask for quiet.
bool progressIsWatched();

/// No progress from here on.
void beQuiet();

/// JSON as text for standard output, whatever bytes its texts hold.
template <typename Json>
std::string asText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

/// The same on one line.
template <typename Json>
std::string asLine(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace breakaway::cli
