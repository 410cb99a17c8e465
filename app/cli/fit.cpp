#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/statistics.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/inverse_fit.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/fit/scale_check.h"
#include "diagnose/search/model_fit.h"
#include "diagnose/simulate/model_file.h"

namespace breakaway::cli {

namespace {

constexpr double window_s = 0.5;

struct FitLine {
  std::string bench, out, method = "simulation";
  std::vector<std::string> recordings, effects;
};

Result<void> checkEffects(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Effect* effect : catalogue()) known.emplace_back(effect->name());
  for (const std::string& name : names) {
    if (findEffect(name) != nullptr) continue;
    const auto suggestion = nearestName(name, known);
    return Error{"--effects", "\"" + name + "\" is not in the catalogue" +
                                  (suggestion ? ", did you mean " + *suggestion + "?" : std::string())};
  }
  return {};
}

std::string inWords(const Model& model) {
  std::string words;
  const auto show = [&words](const std::string& prefix, const Parameter& one) {
    words += fmt::format("{:<44} {:>12.6g}   [{:.6g}, {:.6g}]\n", prefix + one.name, one.value, one.low95, one.high95);
  };
  for (const Parameter& one : model.base) show("", one);
  for (const EffectTerm& term : model.effects) {
    for (const Parameter& one : presentParameters(term, model.axis)) show(term.effect + ": ", one);
  }
  return words;
}

struct Fitted {
  Model model;
  std::string how;
};

Result<Fitted> fitted(const FitLine& line, const Preparation& prepared) {
  if (line.method == "inverse") {
    Model model = prepared.starts.front();
    for (const std::string& name : line.effects) model.effects.push_back({name, {}});
    auto fit = fitInverse(model, prepared.tracks);
    if (!fit) return fit.error();
    return Fitted{fit->model,
                  fmt::format("least squares on the inverse model, {} filtered rows, relative error {:.2f} %\n",
                              fit->rows, 100.0 * fit->relativeError)};
  }
  const SearchInput input(prepared, 1);
  auto fit = fitNamed(input, prepared.starts, line.effects);
  if (!fit) return fit.error();
  return Fitted{withDoubts(fit->model, prepared), fmt::format("least squares over {} restarted windows: {}\n",
                                                              prepared.split.train.size(), fit->termination)};
}

Answer answerOf(const FitLine& line, const Fitted& fit, const ScaleCheck& scales, const std::string& channel,
                double error) {
  auto json = nlohmann::ordered_json::parse(modelText(fit.model));
  json["fit"] = {{"method", line.method}, {"channel", channel}, {"metric", "rmse"},
                 {"window_s", window_s},  {"train", error},     {"model", line.out}};
  std::string first;
  if (scales.misread) {
    first = "Misread: " + scales.misread->sentence + ".\nWith " + scales.misread->mended + ":\n";
    json["fit"]["misread"] = scales.misread->sentence;
    json["fit"]["mended"] = scales.misread->mended;
  }
  for (const std::string& remark : scales.remarks) first += "Note: " + remark + ".\n";
  return {first + fit.how + inWords(fit.model) +
              fmt::format("{}: {:.4g} rms over windows restarted every {} s\nModel: {}\n", channel, error, window_s,
                          line.out),
          asText(json)};
}

Result<Answer> runFit(const FitLine& line) {
  if (auto known = checkEffects(line.effects); !known) return known.error();
  std::vector<std::string> inputs = line.recordings;
  inputs.push_back(line.bench);
  if (auto good = checkOutput(line.out, inputs); !good) return good.error();
  const auto bench = readBench(line.bench);
  if (!bench) return bench.error();
  const auto recordings = readRecordings(line.recordings);
  if (!recordings) return recordings.error();
  const auto scales = checkScales(*bench, *recordings);
  if (!scales) return scales.error();
  const std::optional<Misreading>& misread = scales->misread;
  const auto prepared =
      prepare(misread ? mended(*bench, *misread) : *bench, mended(*recordings, misread), {}, window_s, HeldOut::none);
  if (!prepared) return prepared.error();
  const auto fit = fitted(line, *prepared);
  if (!fit) return fit.error();
  const double error = std::sqrt(mean(scoreWindows(fit->model, prepared->tracks, prepared->split.trainScore)));
  if (auto written = writeModel(fit->model, line.out); !written) return written.error();
  const bool speedAlone = prepared->tracks.front().speedAlone();
  return answerOf(line, *fit, *scales, speedAlone ? bench->velocityChannel() : bench->positionChannel(), error);
}

}  // namespace

void addFit(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<FitLine>();
  auto* command = app.add_subcommand("fit", "Fit the base model, and exactly the effects named, to recordings");
  command->add_option("--bench", line->bench, "bench file, NAME.bench.json")->required();
  command->add_option("--recording", line->recordings, "one or more recordings, NAME.csv; - is standard input")
      ->required();
  command
      ->add_option("--effects", line->effects, "effects to add, by their names in the catalogue, separated by commas")
      ->delimiter(',');
  command
      ->add_option("--method", line->method,
                   "simulation: restarted windows; inverse: least squares on the filtered inverse model")
      ->capture_default_str()
      ->check(CLI::IsMember({"simulation", "inverse"}));
  command->add_option("--out", line->out, "model file to write")->required();
  command->footer(
      "Examples:\n"
      "  breakaway fit --bench b.json --recording a.csv --out model.json\n"
      "  breakaway fit --bench b.json --recording a.csv --effects stribeck,cogging --out model.json\n"
      "breakaway list effects names the effects.");
  command->callback([line, &chosen] { chosen = [line] { return runFit(*line); }; });
}

}  // namespace breakaway::cli
