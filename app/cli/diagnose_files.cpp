#include "cli/diagnose_files.h"

#include <cstdio>

#include "cli/inputs.h"
#include "report/diagnosis_report.h"

namespace breakaway::cli {

Result<Diagnosis> diagnoseFiles(const DiagnosedFiles& files) {
  const auto bench = readBench(files.bench);
  if (!bench) return bench.error();
  const auto recordings = readRecordings(files.recordings);
  if (!recordings) return recordings.error();
  const auto heldout = readRecordings(files.heldout);
  if (!heldout) return heldout.error();
  DiagnoseOptions options;
  options.seed = files.seed;
  if (progressIsWatched()) {
    options.progress = [](double part, const std::string& activity) {
      std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100.0 * part, activity.c_str());
    };
  }
  auto diagnosis = diagnose(*bench, *recordings, *heldout, options);
  if (progressIsWatched()) std::fprintf(stderr, "\r\033[K");
  if (!diagnosis) return diagnosis.error();
  if (auto done = writeDiagnosisFolder(*diagnosis, *bench, *recordings, *heldout, files.out); !done) {
    return done.error();
  }
  return diagnosis;
}

}  // namespace breakaway::cli
