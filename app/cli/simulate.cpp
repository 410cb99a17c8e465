#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/exact_text.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/number_range.h"
#include "diagnose/simulate/model_file.h"
#include "diagnose/simulate/simulation.h"
#include "recording/csv.h"

namespace breakaway::cli {

namespace {

struct SimulateLine {
  std::string model, recording, out;
  double restartEvery_s = 0.0;
};

void append(std::string& text, double value) {
  text += ',';
  appendExact(text, value);
}

Result<Answer> runSimulate(const SimulateLine& line) {
  if (auto good = checkOutput(line.out, {line.model, line.recording}); !good) return good.error();
  const auto model = readModel(line.model);
  if (!model) return model.error();
  const auto content = readFile(line.recording);
  if (!content) return content.error();
  const auto recording = readCsvText(*content, line.recording);
  if (!recording) return recording.error();
  const auto times = timeTextIn(*content, line.recording);
  if (!times) return times.error();
  const auto trace = simulate(*model, *recording, {line.restartEvery_s});
  if (!trace) return trace.error();
  std::string out =
      model->axis == Axis::rotary ? "time_s,angle_rad,velocity_rad_per_s" : "time_s,position_m,velocity_m_per_s";
  if (!trace->current_A.empty()) out += ",current_A";
  out += '\n';
  for (size_t k = 0; k < trace->position.size(); ++k) {
    out += (*times)[k];
    append(out, trace->position[k]);
    append(out, trace->velocity[k]);
    if (!trace->current_A.empty()) append(out, trace->current_A[k]);
    out += '\n';
  }
  if (auto written = writeFile(line.out, out); !written) return written.error();
  const nlohmann::ordered_json json{{"out", line.out}, {"rows", times->size()}};
  return Answer{line.out + ": " + std::to_string(times->size()) + " rows\n", asText(json)};
}

}  // namespace

void addSimulate(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<SimulateLine>();
  auto* command = app.add_subcommand("simulate", "Predict a recording's motion from its drive input alone");
  command->add_option("--model", line->model, "model file from fit or diagnose")->required();
  command
      ->add_option("--recording", line->recording, "recording whose drive input is used, NAME.csv; - is standard input")
      ->required();
  command->add_option("--out", line->out, "CSV to write, one row per row of the recording")->required();
  command
      ->add_option("--restart-every", line->restartEvery_s,
                   "set the state again from measurements every so many seconds")
      ->check(numberIn(1e-9, 1e9));
  command->footer(
      "Examples:\n"
      "  breakaway simulate --model d/model.json --recording a.csv --out sim.csv\n"
      "  breakaway simulate --model d/model.json --recording a.csv --restart-every 0.5 --out -");
  command->callback([line, &chosen] { chosen = [line] { return runSimulate(*line); }; });
}

}  // namespace breakaway::cli
