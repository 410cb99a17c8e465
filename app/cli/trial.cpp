#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/made.h"
#include "base/output_folder.h"
#include "cli/command.h"
#include "cli/diagnose_files.h"
#include "cli/inputs.h"
#include "diagnose/verdict/unsealed.h"
#include "trial/sealed_trial.h"

namespace breakaway::cli {

namespace {

struct TrialLine {
  std::string out, family;
  std::uint64_t seed = 0;
};

using Names = std::vector<std::string>;

std::string listed(const Names& names) {
  std::string words;
  for (const std::string& name : names) words += (words.empty() ? "" : ", ") + name;
  return words;
}

/// What was concealed beside what was named.
std::string truthInWords(const Names& truth, const Unsealed& unsealed) {
  std::string words = "Concealed was: " + (truth.empty() ? "nothing" : listed(truth)) + ". The answer is " +
                      (unsealed.isRight ? "right" : "wrong") + ".";
  if (unsealed.isRight) return words;
  if (!unsealed.right.empty()) words += " Right: " + listed(unsealed.right) + ".";
  if (!unsealed.missed.empty()) words += " Missed: " + listed(unsealed.missed) + ".";
  if (!unsealed.wrong.empty()) words += " Wrong: " + listed(unsealed.wrong) + ".";
  return words;
}

/// Where writeTrial() put the trial, and where its diagnosis goes.
DiagnosedFiles filesOf(const SealedTrial& trial, const std::string& folder) {
  DiagnosedFiles files{folder + "/bench.json", folder + "/diagnosis", {}, {}, 1};
  for (const Recording& one : trial.recordings) files.recordings.push_back(folder + "/" + one.name());
  for (const Recording& one : trial.heldout) files.heldout.push_back(folder + "/" + one.name());
  return files;
}

/// `out`: where `folder` is put in place.
Result<Answer> answerOf(const SealedTrial& trial, const Diagnosis& diagnosis, const std::string& folder,
                        const std::string& out) {
  using Json = nlohmann::ordered_json;
  Names answer, truth;
  for (const Finding& finding : diagnosis.findings) answer.push_back(finding.effect);
  Json concealed = Json::array();
  for (const Concealed& one : trial.truth) {
    truth.push_back(one.effect);
    Json values = Json::object();
    for (const auto& [name, value] : one.parameters) values[name] = value;
    concealed.push_back({{"effect", one.effect}, {"parameters", values}});
  }
  const Unsealed unsealed = unseal(truth, !trial.outside.empty(), answer, diagnosis.verdict);
  const Json json{
      {"schema", "breakaway.trial/1"},
      {"family", trial.family},
      {"seed", trial.seed},
      {"answer", answer},
      {"truth", truth},
      {"right", unsealed.isRight},
      {"verdict", nameOf(diagnosis.verdict)},
      {"outside", trial.outside},
      {"concealed", concealed},
      {"wander", {{"share_of_friction", trial.wanderShare}, {"correlation_s", trial.wander_s}}},
      {"diagnosis", std::filesystem::absolute(out + "/diagnosis/diagnosis.json").lexically_normal().string()}};
  if (auto done =
          writeFile(folder + "/trial.json", withMade(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"));
      !done)
    return done.error();
  return Answer{inWords(diagnosis) + truthInWords(truth, unsealed) + "\nReport: " + out + "/diagnosis/report.html\n",
                asText(json)};
}

Result<Answer> runTrial(const TrialLine& line) {
  auto out = OutputFolder::open({line.out, "trial", {"bench.json", "recording.csv", "diagnosis", "trial.json"}, {}});
  if (!out) return out.error();
  const SealedTrial trial = makeTrial(line.family.empty() ? familyOf(line.seed) : line.family, line.seed);
  Answer answer;
  const auto done = out->fill([&](const std::string& folder) -> Result<void> {
    if (auto put = writeTrial(trial, folder); !put) return put;
    const auto diagnosis = diagnoseFiles(filesOf(trial, folder));
    if (!diagnosis) return diagnosis.error();
    auto unsealed = answerOf(trial, *diagnosis, folder, line.out);
    if (!unsealed) return unsealed.error();
    answer = std::move(*unsealed);
    return {};
  });
  if (!done) return done.error();
  answer.words = out->inWords() + answer.words;
  return answer;
}

}  // namespace

void addTrial(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<TrialLine>();
  auto* command = app.add_subcommand(
      "trial", "Conceal physics in a simulated rig, record it, diagnose from the files alone, and only then unseal");
  command->add_option("--seed", line->seed, "seed of the rig and of what it conceals")->required();
  command->add_option("--out", line->out, "folder for bench.json, recordings, the diagnosis and trial.json")
      ->required();
  command
      ->add_option("--family", line->family,
                   "an effect's name, combination, masked, noisy, weak, low, outside, clean, imperfect or rough; drawn "
                   "by default")
      ->check(CLI::IsMember(trialFamilies()));
  command->footer(
      "Examples:\n"
      "  breakaway trial --seed 7 --out t\n"
      "  breakaway trial --seed 7 --family backlash --out t --json");
  command->callback([line, &chosen] { chosen = [line] { return runTrial(*line); }; });
}

}  // namespace breakaway::cli
