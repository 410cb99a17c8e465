#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/output_folder.h"
#include "cli/command.h"
#include "cli/diagnose_files.h"
#include "cli/inputs.h"
#include "cli/into_project.h"
#include "cli/number_range.h"

namespace breakaway::cli {

namespace {

OutputPlan outputOf(const DiagnosedFiles& files) {
  OutputPlan plan{files.out,
                  "diagnose",
                  {"base_model.json", "model.json", "report.html", "figures", "diagnosis.json"},
                  files.recordings};
  plan.inputs.push_back(files.bench);
  plan.inputs.insert(plan.inputs.end(), files.heldout.begin(), files.heldout.end());
  return plan;
}

Result<Answer> runDiagnose(const DiagnosedFiles& files, const std::string& projectFolder) {
  auto project = openAskedProject(projectFolder);
  if (!project) return project.error();
  auto out = OutputFolder::open(outputOf(files));
  if (!out) return out.error();
  std::optional<Diagnosis> diagnosis;
  const auto done = out->fill([&](const std::string& folder) -> Result<void> {
    DiagnosedFiles staged = files;
    staged.out = folder;
    auto found = diagnoseFiles(staged);
    if (!found) return found.error();
    diagnosis = std::move(*found);
    return {};
  });
  if (!done) return done.error();
  auto json = nlohmann::ordered_json::parse(diagnosisJson(*diagnosis, true));
  json["report"] = files.out + "/report.html";
  const Answer answer{out->inWords() + inWords(*diagnosis) + "Report: " + files.out + "/report.html\n", asText(json)};
  return intoProject(*project, {.sources = {files.out}, .only = out->files(), .motor = motorOf(files.bench)}, answer);
}

}  // namespace

void addDiagnose(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<DiagnosedFiles>();
  auto project = std::make_shared<std::string>();
  auto* command = app.add_subcommand(
      "diagnose", "Find where simulation and recordings part, which physics is missing, and prove it");
  command->add_option("--bench", line->bench, "bench file, NAME.bench.json")->required();
  command
      ->add_option("--recording", line->recordings,
                   "one or more recordings to learn from, NAME.csv; - is standard input")
      ->required();
  command->add_option("--heldout", line->heldout,
                      "recordings to prove on; without any, parts of the recordings are held out");
  command
      ->add_option("--out", line->out,
                   "folder for diagnosis.json, model.json, base_model.json, report.html and figures")
      ->required();
  command->add_option("--seed", line->seed, "seed of everything random")->capture_default_str();
  command
      ->add_option("--time", line->time_s, "seconds that it may take: the best answer within them; default: no limit")
      ->check(numberIn(1e-3, 1e7));
  addProjectOption(*command, *project);
  command->footer(
      "Examples:\n"
      "  breakaway diagnose --bench axis7.bench.json --recording march.csv --out d\n"
      "  breakaway diagnose --bench b.json --recording a.csv b.csv --heldout c.csv --out d\n"
      "  breakaway import log.mat --out - | breakaway diagnose --bench b.json --recording - --out d --json");
  command->callback([line, project, &chosen] { chosen = [line, project] { return runDiagnose(*line, *project); }; });
}

}  // namespace breakaway::cli
