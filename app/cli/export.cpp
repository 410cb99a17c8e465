#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "diagnose/simulate/model_file.h"
#include "export/gains.h"
#include "export/model_export.h"
#include "export/portable/program.h"
#include "export/program_name.h"
#include "friction/map_export.h"
#include "recording/csv.h"

namespace breakaway::cli {

namespace {

struct ExportLine {
  std::string map, model, tuning, form, out, name, recording;
  int polePairs = 0;  ///< 0: not given
};

/// "{a,b}"
std::string among(const std::vector<std::string>& forms) {
  return "{" + CLI::detail::join(forms, ",") + "}";
}

/// Each form of anything once, in the order of maps, models, gains.
std::vector<std::string> allForms() {
  std::vector<std::string> all = mapForms();
  for (const auto* more : {&modelForms(), &gainForms()}) {
    for (const std::string& one : *more) {
      if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
    }
  }
  return all;
}

/// One of the forms of what is exported. The error reads as the parser's own.
Result<void> checkForm(const std::string& form, const std::vector<std::string>& forms) {
  if (std::find(forms.begin(), forms.end(), form) != forms.end()) return {};
  return Error{"--as", form + " not in " + among(forms) + "; see breakaway export --help"};
}

Result<Answer> exportedMap(const ExportLine& line) {
  if (auto good = checkForm(line.form, mapForms()); !good) return good.error();
  if (!line.name.empty()) {
    if (line.form != "c-header" && line.form != "modelica")
      return Error{"--name", "goes with c-header and modelica only, of a map"};
    if (const auto fault = nameFault(line.form, line.name))
      return Error{"--name", "is \"" + line.name + "\", " + *fault};
  }
  if (auto good = checkOutput(line.out, {line.map}); !good) return good.error();
  const auto map = readMap(line.map);
  if (!map) return map.error();
  if (auto done = exportMap(*map, line.form, line.out, line.name); !done) {
    const bool ofMap = done.error().place.starts_with("bin ");
    return ofMap ? Error{line.map + ", " + done.error().place, done.error().fact} : done.error();
  }
  const nlohmann::ordered_json json{{"out", line.out}, {"bins", map->bins.size()}};
  return Answer{line.out + ": " + std::to_string(map->bins.size()) + " bins\n", asText(json)};
}

/// The output's own name where that may be one, else the program's. C has no names but by prefix.
std::string nameFor(const ExportLine& line, const Model& model) {
  if (!line.name.empty()) return line.name;
  const std::string stem = std::filesystem::path(line.out).stem().string();
  return line.form != "c" && !nameFault(model, line.form, stem) ? stem : "breakaway";
}

/// What has to be said of a file whose language finds it by its name.
void noteOnFile(const ExportLine& line, const std::string& name, std::vector<std::string>& notes) {
  const std::filesystem::path path(line.out);
  if (line.out == "-") return;
  if (line.form == "matlab" && path.filename() != name + ".m")
    notes.push_back("MATLAB finds the class only in a file of its name: keep it as " + name + ".m.");
  if (line.form == "python" && (path.extension() != ".py" || !isIdentifier(path.stem().string())))
    notes.emplace_back("Python imports it only from a file like motor.py, of letters, digits and _.");
}

Result<Answer> exportedModel(const ExportLine& line) {
  if (auto good = checkForm(line.form, modelForms()); !good) return good.error();
  if (auto good = checkOutput(line.out, {line.model, line.recording}); !good) return good.error();
  const auto model = readModel(line.model);
  if (!model) return model.error();
  if (const auto fault = line.name.empty() ? std::nullopt : nameFault(*model, line.form, line.name))
    return Error{"--name", "is \"" + line.name + "\", " + *fault};
  ModelExportOptions options{.model = line.model, .name = nameFor(line, *model)};
  std::vector<Recording> recordings;
  if (!line.recording.empty()) {
    auto read = readRecordings({line.recording});
    if (!read) return read.error();
    recordings = std::move(*read);
    options.recording = &recordings.front();
  }
  auto done = exportModel(*model, line.form, options);
  if (!done) {
    const bool ofRecording = options.recording != nullptr && done.error().place.starts_with(line.recording);
    return ofRecording ? done.error() : Error{line.model + ", " + done.error().place, done.error().fact};
  }
  if (auto written = writeFile(line.out, done->text); !written) return written.error();
  noteOnFile(line, options.name, done->notes);
  std::string words;
  for (const std::string& note : done->notes) words += note + "\n";
  const nlohmann::ordered_json json{{"out", line.out}, {"form", line.form}, {"notes", done->notes}};
  return Answer{words + line.out + ": the model as " + line.form + "\n", asText(json)};
}

Result<Answer> exportedGains(const ExportLine& line) {
  if (auto good = checkForm(line.form, gainForms()); !good) return good.error();
  if (auto good = checkOutput(line.out, {line.tuning}); !good) return good.error();
  const auto gains = readTuning(line.tuning);
  if (!gains) return gains.error();
  const auto done = exportGains(*gains, line.form, line.tuning,
                                line.polePairs > 0 ? std::optional<double>(line.polePairs) : std::nullopt);
  if (!done) return done.error();
  if (auto written = writeFile(line.out, done->text); !written) return written.error();
  std::string words;
  for (const std::string& note : done->notes) words += note + "\n";
  const nlohmann::ordered_json json{{"out", line.out}, {"form", line.form}, {"notes", done->notes}};
  return Answer{words + line.out + ": the gains for " + line.form + "\n", asText(json)};
}

/// Options that only some exports take are no silent extras.
Result<void> checkExtras(const ExportLine& line) {
  if (!line.tuning.empty() && !line.name.empty()) return Error{"--name", "goes with --map and --model only"};
  if (line.model.empty() && !line.recording.empty()) return Error{"--recording", "goes with --model only"};
  if (line.tuning.empty() && line.polePairs > 0) return Error{"--pole-pairs", "goes with --tuning only"};
  return {};
}

Result<Answer> exported(const ExportLine& line) {
  if (auto good = checkExtras(line); !good) return good.error();
  if (!line.tuning.empty()) return exportedGains(line);
  return line.model.empty() ? exportedMap(line) : exportedModel(line);
}

}  // namespace

void addExport(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<ExportLine>();
  auto* command = app.add_subcommand(
      "export", "Write a friction map, a fitted model or gains in the form that another program reads");
  auto* what = command->add_option_group("what");
  what->add_option("--map", line->map, "map to read, map.json; - is standard input");
  what->add_option("--model", line->model, "model to read, model.json from fit or diagnose; - is standard input");
  what->add_option("--tuning", line->tuning, "tuning to read, tuning.json; - is standard input");
  what->require_option(1);
  command
      ->add_option("--as", line->form,
                   "the form. Of a map: csv, json, c-header, mat, modelica. Of a model: mjcf, isaaclab, urdf, sdf, c, "
                   "python, modelica, matlab. Of a tuning: simplefoc, odrive, vesc")
      ->type_name("TEXT:" + among(allForms()))
      ->required();
  command->add_option("--out", line->out, "file to write; - is standard output")->required();
  command->add_option(
      "--name", line->name,
      "of prefix (C), joint, class or package, so that two stand in one program; else the output's own, "
      "for C and of a map breakaway's");
  command->add_option("--recording", line->recording,
                      "of a model as mjcf, isaaclab, urdf or sdf: on which its error with what the joint holds is held "
                      "against its own, NAME.csv");
  command->add_option("--pole-pairs", line->polePairs, "of the motor, for vesc")->check(CLI::Range(1, 1000));
  command->footer(
      "Examples:\n"
      "  breakaway export --map c/map.json --as c-header --out friction_map.h\n"
      "  breakaway export --map left/map.json --as c-header --name left --out left.h\n"
      "  breakaway export --map c/map.json --as csv --out - | head\n"
      "  breakaway export --model d/model.json --as c --out motor.h\n"
      "  breakaway export --model d/model.json --as mjcf --out joint.xml --recording a.csv\n"
      "  breakaway export --tuning t/tuning.json --as vesc --pole-pairs 7 --out gains.txt");
  command->callback([line, &chosen] { chosen = [line]() -> Outcome { return exported(*line); }; });
}

}  // namespace breakaway::cli
