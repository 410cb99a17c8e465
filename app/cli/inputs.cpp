#include "cli/inputs.h"

#include <unistd.h>

#include "recording/csv.h"

namespace breakaway::cli {

Result<std::vector<Recording>> readRecordings(const std::vector<std::string>& paths) {
  std::vector<Recording> recordings;
  for (const std::string& path : paths) {
    auto recording = readCsv(path);
    if (!recording) return recording.error();
    recordings.push_back(std::move(*recording));
  }
  return recordings;
}

bool progressIsWatched() {
  return ::isatty(STDERR_FILENO) == 1;
}

}  // namespace breakaway::cli
