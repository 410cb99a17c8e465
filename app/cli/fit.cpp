#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "base/json_object.h"
#include "base/statistics.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/inverse_fit.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/search/model_fit.h"
#include "diagnose/simulate/model_file.h"

namespace breakaway::cli {

namespace {

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

void print(const Model& model) {
  const auto show = [](const std::string& prefix, const Parameter& one) {
    std::printf("%-44s %12.6g   [%.6g, %.6g]\n", (prefix + one.name).c_str(), one.value, one.low95, one.high95);
  };
  for (const Parameter& one : model.base) show("", one);
  for (const EffectTerm& term : model.effects) {
    for (const Parameter& one : presentParameters(term, model.axis)) show(term.effect + ": ", one);
  }
}

Result<Model> fitted(const FitLine& line, const Preparation& prepared) {
  if (line.method == "inverse") {
    Model model = prepared.starts.front();
    for (const std::string& name : line.effects) model.effects.push_back({name, {}});
    auto fit = fitInverse(model, prepared.tracks);
    if (!fit) return fit.error();
    std::printf("least squares on the inverse model, %zu filtered rows, relative error %.2f %%\n", fit->rows,
                100.0 * fit->relativeError);
    return fit->model;
  }
  const SearchInput input(prepared, 1);
  auto fit = fitNamed(input, prepared.starts, line.effects);
  if (!fit) return fit.error();
  std::printf("least squares over %zu restarted windows: %s\n", prepared.split.train.size(), fit->termination.c_str());
  return withDoubts(fit->model, prepared);
}

Result<void> runFit(const FitLine& line) {
  if (auto known = checkEffects(line.effects); !known) return known;
  const auto bench = readBench(line.bench);
  if (!bench) return bench.error();
  const auto recordings = readRecordings(line.recordings);
  if (!recordings) return recordings.error();
  const auto prepared = prepare(*bench, *recordings, {}, 0.5, HeldOut::none);
  if (!prepared) return prepared.error();
  const auto model = fitted(line, *prepared);
  if (!model) return model.error();
  print(*model);
  const double error = std::sqrt(mean(scoreWindows(*model, prepared->tracks, prepared->split.trainScore)));
  std::printf("%s: %.4g rms over windows restarted every 0.5 s\n", bench->positionChannel().c_str(), error);
  return writeModel(*model, line.out);
}

}  // namespace

void addFit(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<FitLine>();
  auto* command = app.add_subcommand("fit", "Fit the base model, and exactly the effects named, to recordings");
  command->add_option("--bench", line->bench, "bench file, NAME.bench.json")->required();
  command->add_option("--recording", line->recordings, "one or more recordings, NAME.csv")->required();
  command
      ->add_option("--effects", line->effects, "effects to add, by their names in the catalogue, separated by commas")
      ->delimiter(',');
  command
      ->add_option("--method", line->method,
                   "simulation: restarted windows (default); inverse: least squares on the filtered inverse model")
      ->check(CLI::IsMember({"simulation", "inverse"}));
  command->add_option("--out", line->out, "model file to write")->required();
  command->callback([line, &chosen] { chosen = [line] { return runFit(*line); }; });
}

}  // namespace breakaway::cli
