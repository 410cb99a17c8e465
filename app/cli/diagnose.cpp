#include "diagnose/diagnosis.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/command.h"
#include "cli/inputs.h"
#include "report/diagnosis_report.h"

namespace breakaway::cli {

namespace {

struct DiagnoseLine {
  std::string bench, out;
  std::vector<std::string> recordings, heldout;
  unsigned seed = 1;
};

Result<void> runDiagnose(const DiagnoseLine& line) {
  const auto in = readDiagnosisInputs(line.bench, line.recordings, line.heldout);
  if (!in) return in.error();
  DiagnoseOptions options;
  options.seed = line.seed;
  if (progressIsWatched()) {
    options.progress = [](double part, const std::string& activity) {
      std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100.0 * part, activity.c_str());
    };
  }
  const auto diagnosis = diagnose(in->bench, in->recordings, in->heldout, options);
  if (progressIsWatched()) std::fprintf(stderr, "\r\033[K");
  if (!diagnosis) return diagnosis.error();
  if (auto done = writeDiagnosisFolder(*diagnosis, in->bench, in->recordings, in->heldout, line.out); !done)
    return done;
  std::fputs(inWords(*diagnosis).c_str(), stdout);
  return {};
}

}  // namespace

void addDiagnose(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<DiagnoseLine>();
  auto* command = app.add_subcommand(
      "diagnose", "Find where simulation and recordings part, which physics is missing, and prove it");
  command->add_option("--bench", line->bench, "bench file, NAME.bench.json")->required();
  command->add_option("--recording", line->recordings, "one or more recordings to learn from, NAME.csv")->required();
  command->add_option("--heldout", line->heldout,
                      "recordings to prove on; without any, parts of the recordings are held out");
  command
      ->add_option("--out", line->out,
                   "folder for diagnosis.json, model.json, base_model.json, report.html and figures")
      ->required();
  command->add_option("--seed", line->seed, "seed of everything random");
  command->callback([line, &chosen] { chosen = [line] { return runDiagnose(*line); }; });
}

}  // namespace breakaway::cli
