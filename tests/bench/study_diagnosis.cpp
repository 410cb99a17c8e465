// The diagnosis on sealed trials, scored against the truth, beside two baselines. Resumable: one line per trial.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/line_log.h"
#include "base/shard.h"
#include "bench/regression_baselines.h"
#include "diagnose/model/criteria.h"
#include "score/identifiability.h"
#include "score/scored_seeds.h"
#include "score/scoring.h"
#include "score/sensitivity.h"
#include "trial/sealed_trial.h"

using namespace breakaway;

namespace {

struct Options {
  std::string results, earlier, shard = "1/1";
  std::vector<std::string> families;
  size_t count = 0;
  bool tuning = false, release = false, printOnly = false, answersOnly = false, sensitivity = false, criteria = false;

  SeedRange seeds() const { return tuning || sensitivity ? tuningSeeds : release ? releaseSeeds : scoredSeeds; }
  const char* seedsName() const { return tuning || sensitivity ? "tuning" : release ? "release" : "scored"; }
};

struct Job {
  std::string family;
  std::uint64_t seed = 0;
  auto operator<=>(const Job&) const = default;
};

constexpr size_t drawnForSensitivity = 3;  ///< of each family: more than a hundred in all

size_t runsOf(const std::string& family) {
  if (family == "clean") return 300;
  for (const char* many : {"combination", "masked", "noisy", "weak", "low", "outside"}) {
    if (family == many) return 60;
  }
  return 20;
}

/// All trials, one of each family before the second of any, so that a part of them is a fair sample.
std::vector<Job> jobsOf(const Options& options) {
  std::vector<Job> jobs;
  const auto runs = [&options](const std::string& family) {
    return options.count > 0 ? options.count : options.sensitivity ? drawnForSensitivity : runsOf(family);
  };
  size_t most = 0;
  for (const std::string& family : options.families) most = std::max(most, runs(family));
  for (size_t k = 0; k < most; ++k) {
    for (const std::string& family : options.families) {
      if (k < runs(family)) jobs.push_back({family, options.seeds().first + k});
    }
  }
  return jobs;
}

/// `known` is an earlier score of the same trial: what the baselines say, and what the truth shows, doesn't rest on the
/// search.
ScoredTrial scoredTrial(const Job& job, const ScoredTrial* known, bool answersOnly) {
  const SealedTrial trial = makeTrial(job.family, job.seed);
  ScoredTrial scored = judge(trial, diagnose(trial.bench, trial.recordings, trial.heldout, {}));
  if (known != nullptr) {
    scored.stepwise = known->stepwise;
    scored.thresholded = known->thresholded;
    scored.unidentified = known->unidentified;
    scored.identifiable = known->identifiable;
    scored.size = known->size;
    scored.achievable = known->achievable;
    return scored;
  }
  if (answersOnly) {
    scored.unidentified = "what the truth shows was not looked at";
    return scored;
  }
  if (const auto prepared = prepare(trial.bench, trial.recordings, trial.heldout, 0.5)) {
    const test::TorqueColumns columns = test::torqueColumns(*prepared);
    scored.stepwise = test::stepwiseNames(columns);
    scored.thresholded = test::thresholdedNames(columns);
  }
  const auto shown = identifiability(trial);
  if (!shown) {
    scored.unidentified = shown.error().message();
    return scored;
  }
  scored.identifiable = shown->identifiable();
  scored.size = shown->floor > 0.0 ? shown->base / shown->floor : 0.0;
  scored.achievable = shown->truth;
  return scored;
}

Result<std::vector<ScoredTrial>> readScored(const Options& options, const std::string& file) {
  const auto lines = readWholeLines(file);
  if (!lines) return lines.error();
  std::vector<ScoredTrial> trials;
  for (size_t k = 0; k < lines->size(); ++k) {
    auto trial = parseScoredLine((*lines)[k], file + ", line " + std::to_string(k + 1));
    if (!trial) return trial.error();
    const auto& wanted = options.families;
    if (options.seeds().holds(trial->seed) && std::find(wanted.begin(), wanted.end(), trial->family) != wanted.end())
      trials.push_back(std::move(*trial));
  }
  return trials;
}

Result<void> run(const Options& options) {
  const auto shard = parseShard(options.shard);
  if (!shard) return shard.error();
  const auto done = readScored(options, options.results);
  if (!done) return done.error();
  std::map<Job, ScoredTrial> earlier;
  if (!options.earlier.empty()) {
    const auto read = readScored(options, options.earlier);
    if (!read) return read.error();
    for (const ScoredTrial& trial : *read) earlier.emplace(Job{trial.family, trial.seed}, trial);
  }
  std::set<Job> finished;
  for (const ScoredTrial& trial : *done) finished.insert({trial.family, trial.seed});
  const auto folder = std::filesystem::path(options.results).parent_path();
  if (!folder.empty()) {
    if (auto made = makeFolder(folder.string()); !made) return made;
  }
  const auto jobs = jobsOf(options);
  for (size_t k = 0; k < jobs.size(); ++k) {
    if (!shard->holds(k) || finished.contains(jobs[k])) continue;
    const auto known = earlier.find(jobs[k]);
    const ScoredTrial trial =
        scoredTrial(jobs[k], known != earlier.end() ? &known->second : nullptr, options.answersOnly);
    if (auto written = appendLine(options.results, scoredLine(trial)); !written) return written;
    std::fprintf(stderr, "%zu of %zu: %s %llu: %s%s%s, %.1f s\n", k + 1, jobs.size(), trial.family.c_str(),
                 static_cast<unsigned long long>(trial.seed), trial.verdict.c_str(), trial.answer.empty() ? "" : " ",
                 trial.answer.empty() ? trial.error.c_str() : trial.answer.front().effect.c_str(), trial.elapsed_s);
  }
  return {};
}

Result<std::vector<VariedTrial>> readVaried(const std::string& file) {
  const auto lines = readWholeLines(file);
  if (!lines) return lines.error();
  std::vector<VariedTrial> all;
  for (size_t k = 0; k < lines->size(); ++k) {
    auto one = parseVariedLine((*lines)[k], file + ", line " + std::to_string(k + 1));
    if (!one) return one.error();
    all.push_back(std::move(*one));
  }
  return all;
}

/// Every trial of the draw as the criteria are, and with each of them a third smaller and larger.
Result<void> varyCriteria(const Options& options) {
  const auto shard = parseShard(options.shard);
  if (!shard) return shard.error();
  const auto done = readVaried(options.results);
  if (!done) return done.error();
  std::set<std::tuple<std::string, double, Job>> finished;
  for (const VariedTrial& one : *done) finished.insert({one.criterion, one.factor, {one.trial.family, one.trial.seed}});
  std::vector<std::pair<std::string, double>> variations{{"", 1.0}};
  for (const Criterion& one : criteriaTable()) {
    for (const double factor : {0.7, 1.3}) variations.emplace_back(one.name, factor);
  }
  const auto jobs = jobsOf(options);
  for (size_t k = 0; k < jobs.size(); ++k) {
    if (!shard->holds(k)) continue;
    const SealedTrial trial = makeTrial(jobs[k].family, jobs[k].seed);
    for (const auto& [criterion, factor] : variations) {
      if (finished.contains({criterion, factor, jobs[k]})) continue;
      DiagnoseOptions how;
      if (!criterion.empty()) {
        const auto criteria = varied(how.criteria, criterion, factor);
        if (!criteria) return criteria.error();
        how.criteria = *criteria;
      }
      const VariedTrial one{criterion, factor,
                            judge(trial, diagnose(trial.bench, trial.recordings, trial.heldout, how))};
      if (auto written = appendLine(options.results, variedLine(one)); !written) return written;
    }
    std::fprintf(stderr, "%zu of %zu: %s %llu\n", k + 1, jobs.size(), jobs[k].family.c_str(),
                 static_cast<unsigned long long>(jobs[k].seed));
  }
  return {};
}

Result<void> printSensitivity(const Options& options) {
  const auto all = readVaried(options.results);
  if (!all) return all.error();
  std::printf("%s", sensitivityTable(*all).c_str());
  return {};
}

Result<void> print(const Options& options) {
  const auto trials = readScored(options, options.results);
  if (!trials) return trials.error();
  const auto all = jobsOf(options);
  std::printf("%zu of %zu trials, %s seeds\n\n", trials->size(), all.size(), options.seedsName());
  size_t undecided = 0;
  for (const ScoredTrial& trial : *trials) undecided += trial.unidentified.empty() ? 0 : 1;
  if (undecided > 0)
    std::printf("%zu trials count as not identifiable because the truth was not or could not be fitted\n\n", undecided);
  const std::vector<Score> scores{scoreOf(*trials, Method::diagnosis), scoreOf(*trials, Method::stepwise),
                                  scoreOf(*trials, Method::thresholded)};
  std::printf("%s\n%s", familyTable(scores.front()).c_str(), totalsTable(scores).c_str());
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"The diagnosis on sealed trials, scored against the truth", "study_diagnosis"};
  app.add_option(
      "--results", options.results,
      "file that scored trials are appended to; build/diagnosis-scored.jsonl, or -tuning, -release, -sensitivity");
  app.add_option("--earlier", options.earlier,
                 "an earlier such file, from which is taken over what doesn't rest on the search: the baselines' "
                 "answers, and what the truth shows")
      ->check(CLI::ExistingFile);
  app.add_option("--families", options.families, "A,B,...: only these families of trials")
      ->delimiter(',')
      ->check(CLI::IsMember(trialFamilies()));
  app.add_option("--count", options.count, "trials per family in place of 20, 60 or 300");
  app.add_option("--shard", options.shard, "I/N: only every N-th trial, beginning with the I-th");
  app.add_flag(
      "--answers-only", options.answersOnly,
      "a quick look: no baselines, and nothing of what the truth shows, so that no trial counts as identifiable");
  app.add_flag("--tuning", options.tuning, "on the tuning seeds");
  app.add_flag("--release", options.release, "on the seeds that are scored once for each release");
  app.add_flag("--sensitivity", options.sensitivity,
               "each criterion a third smaller and larger, on three tuning trials of each family: what changes");
  app.add_flag("--criteria", options.criteria, "prints the table of criteria, as the manual's appendix holds it");
  app.add_flag("--print-only", options.printOnly, "prints the table of what is in the file");
  CLI11_PARSE(app, argc, argv);
  if (options.criteria) {
    std::printf("%s", criteriaMarkdown().c_str());
    return 0;
  }
  if (options.families.empty()) options.families = trialFamilies();
  if (options.results.empty())
    options.results =
        std::string("build/diagnosis-") + (options.sensitivity ? "sensitivity" : options.seedsName()) + ".jsonl";
  Result<void> done = options.printOnly ? Result<void>() : options.sensitivity ? varyCriteria(options) : run(options);
  if (done) done = options.sensitivity ? printSensitivity(options) : print(options);
  if (done) return 0;
  std::fprintf(stderr, "study_diagnosis: %s\n", done.error().message().c_str());
  return 2;
}
