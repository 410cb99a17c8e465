#include "cli/diagnose_files.h"

#include <cstdio>

#include "cli/inputs.h"
#include "report/diagnosis_report.h"

namespace breakaway::cli {

Result<Diagnosis> diagnoseFiles(const DiagnosedFiles& files) {
  DiagnoseOptions options;
  options.time = TimeLimit(files.time_s);  // reading is part of it
  const auto in = readDiagnosisInputs(files.bench, files.recordings, files.heldout);
  if (!in) return in.error();
  options.seed = files.seed;
  if (progressIsWatched()) {
    options.progress = [](double part, const std::string& activity) {
      std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100.0 * part, activity.c_str());
    };
  }
  auto diagnosis = diagnose(in->bench, in->recordings, in->heldout, options);
  if (progressIsWatched()) std::fprintf(stderr, "\r\033[K");
  if (!diagnosis) return diagnosis.error();
  if (auto done = writeDiagnosisFolder(*diagnosis, in->bench, in->recordings, in->heldout, files.out); !done) {
    return done.error();
  }
  return diagnosis;
}

}  // namespace breakaway::cli
