#include "cli/inputs.h"

#include "base/process.h"
#include "recording/block_file.h"

namespace breakaway::cli {

Result<std::vector<Recording>> readRecordings(const std::vector<std::string>& paths) {
  std::vector<Recording> recordings;
  for (const std::string& path : paths) {
    auto recording = readRecording(path);
    if (!recording) return recording.error();
    recordings.push_back(std::move(*recording));
  }
  return recordings;
}

Result<DiagnosisInputs> readDiagnosisInputs(const std::string& bench, const std::vector<std::string>& recordings,
                                            const std::vector<std::string>& heldout) {
  auto rig = readBench(bench);
  if (!rig) return rig.error();
  auto learned = readRecordings(recordings);
  if (!learned) return learned.error();
  auto proving = readRecordings(heldout);
  if (!proving) return proving.error();
  return DiagnosisInputs{std::move(*rig), std::move(*learned), std::move(*proving)};
}

namespace {
bool quiet = false;
}

bool progressIsWatched() {
  return !quiet && errorsGoToTerminal();
}

void beQuiet() {
  quiet = true;
}

}  // namespace breakaway::cli
