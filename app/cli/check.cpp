#include "diagnose/check/check.h"

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/inputs.h"

namespace breakaway::cli {

namespace {

struct CheckLine {
  std::string bench;
  std::vector<std::string> recordings;
};

Result<Answer> runCheck(const CheckLine& line) {
  const auto in = readDiagnosisInputs(line.bench, line.recordings, {});
  if (!in) return in.error();
  const auto found = check(in->bench, in->recordings);
  if (!found) return found.error();
  return Answer{inWords(*found), checkJson(*found)};
}

}  // namespace

void addCheck(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<CheckLine>();
  auto* command = app.add_subcommand(
      "check",
      "Say how good recordings are, and which effects they can show, from which size on, before any diagnosis");
  command->add_option("--bench", line->bench, "bench file, NAME.bench.json")->required();
  command->add_option("--recording", line->recordings, "one or more recordings, NAME.csv; - is standard input")
      ->required();
  command->footer(
      "Examples:\n"
      "  breakaway check --bench axis7.bench.json --recording march.csv\n"
      "  breakaway check --bench b.json --recording a.csv b.csv --json");
  command->callback([line, &chosen] { chosen = [line] { return runCheck(*line); }; });
}

}  // namespace breakaway::cli
