// Friction maps against the truth: every rotary preset and rigs at random. Resumable: one line per rig in --results.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/line_log.h"
#include "bench/map_families.h"
#include "bench/map_score.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "support/processor_time.h"
#include "support/random_rig.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

struct Job {
  std::string name, uri;
  unsigned seed = 1;
  size_t turns = 2, bins = SweepSettings{}.bins;
};

/// The gain is trusted: the rigs' gain error is zero, and torques rest on the measured back-EMF constant.
MapScore scored(const Job& job) {
  MapScore score;
  score.rig = job.name;
  const auto file = rigFileOf(job.uri);
  const auto rig = file ? readRig(*file) : Result<Rig>(file.error());
  auto drive = openDrive(job.uri, job.seed);
  if (!rig || !drive) {
    score.failure = !rig ? rig.error().message() : drive.error().message();
    return score;
  }
  CommissionOptions options;
  options.rig = job.name;
  options.sweeps.turns = job.turns;
  options.sweeps.bins = job.bins;
  options.keepRecordings = false;
  const ProcessorTime time(ProcessorTime::Of::thread);
  const auto done = commission(**drive, options);
  score.cpu_s = time.elapsed_s();
  if (!done) {
    score.failure = done.error().message();
    return score;
  }
  const auto truth = trueMap(job.uri, options.sweeps.bins, done->map.totalVelocity_rad_per_s);
  if (truth) compare(*done, *truth, *rig, score);
  return score;
}

void printCurve(const CurveScore& one, double target) {
  std::printf(" %6.2f/%-5.2f%c %4.0f", 100.0 * one.rms, 100.0 * one.bound, one.within(target) ? ' ' : '!',
              100.0 * one.covered);
}

void print(const MapScore& score) {
  if (!score.failure.empty()) {
    std::printf("%-16s %s\n", score.rig.c_str(), score.failure.c_str());
    return;
  }
  for (size_t w = 0; w < 2; ++w) {
    const WayScore& way = score.way[w];
    std::printf("%-16s %-3s", w == 0 ? score.rig.c_str() : "", w == 0 ? "cw" : "ccw");
    printCurve(way.still, staticTarget);
    printCurve(way.coulomb, coulombTarget);
    printCurve(way.viscous, viscousTarget);
    std::printf(" %7.4f %5.3f", way.correlation, way.noiseOverSpread);
    if (w == 0) {
      std::printf(" %5.2f %4.0f %5.2f %4.0f %5.0f %5.1f %3.0f", 100.0 * score.friction.rms,
                  100.0 * score.friction.covered, 100.0 * score.position.rms, 100.0 * score.position.covered,
                  score.rig_s, score.cpu_s, score.missed);
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

/// Over both ways of all rigs.
void printSummary(const std::vector<MapScore>& scores) {
  struct Row {
    const char* name;
    CurveScore WayScore::*curve;
    double target;
  };
  const Row rows[] = {{"breakaway", &WayScore::still, staticTarget},
                      {"Coulomb", &WayScore::coulomb, coulombTarget},
                      {"viscous", &WayScore::viscous, viscousTarget}};
  for (const Row& row : rows) {
    double covered = 0.0, worst = 0.0, squares = 0.0;
    size_t within = 0, inTarget = 0, maps = 0;
    for (const MapScore& score : scores) {
      for (const WayScore& way : score.way) {
        if (!score.failure.empty()) continue;
        const CurveScore& one = way.*row.curve;
        ++maps;
        within += one.within(row.target) ? 1 : 0;
        inTarget += one.rms <= row.target ? 1 : 0;
        covered += one.covered;
        worst = std::max(worst, one.rms);
        squares += one.rms * one.rms;
      }
    }
    const auto n = static_cast<double>(std::max<size_t>(1, maps));
    std::printf(
        "%s: %zu of %zu maps within %.0f %% or 1.5 x the bound (%zu within %.0f %%), worst %.2f %%, rms %.2f "
        "%%; 95 %% intervals hold %.1f %% of the bins\n",
        row.name, within, maps, 100.0 * row.target, inTarget, 100.0 * row.target, 100.0 * worst,
        100.0 * std::sqrt(squares / n), 100.0 * covered / n);
  }
  size_t repeatable = 0, correlated = 0, failed = 0;
  double friction = 0.0, position = 0.0, rig_s = 0.0, cpu_s = 0.0;
  for (const MapScore& score : scores) {
    failed += score.failure.empty() ? 0 : 1;
    friction = std::max(friction, score.friction.rms);
    position = std::max(position, score.position.rms);
    rig_s = std::max(rig_s, score.rig_s);
    cpu_s = std::max(cpu_s, score.cpu_s);
    for (const WayScore& way : score.way) {
      if (!score.failure.empty() || way.noiseOverSpread >= repeatableNoise) continue;
      ++repeatable;
      correlated += way.correlation >= leastCorrelation ? 1 : 0;
    }
  }
  std::printf(
      "turns correlate by 0.95 or more in %zu of %zu ways whose noise is below 0.23 of the spread; worst static "
      "friction "
      "%.2f %%, position torque %.2f %%; longest %.0f s on the rig, %.1f s computed; %zu failed\n",
      correlated, repeatable, 100.0 * friction, 100.0 * position, rig_s, cpu_s, failed);
}

/// Coverage of one family, curve by curve and way by way.
void printCoverage(const MapFamily& family, const std::vector<MapScore>& scores) {
  std::array<double, 8> covered{};
  size_t maps = 0, failed = 0;
  for (const MapScore& score : scores) {
    if (!score.failure.empty()) {
      ++failed;
      continue;
    }
    ++maps;
    size_t k = 0;
    for (const WayScore& way : score.way) {
      for (const CurveScore* one : {&way.still, &way.coulomb, &way.viscous}) covered[k++] += one->covered;
    }
    covered[6] += score.friction.covered;
    covered[7] += score.position.covered;
  }
  std::printf("| %s |", family.name.c_str());
  for (const size_t k : {0, 3, 1, 4, 2, 5, 6, 7})
    std::printf(" %.0f |", 100.0 * covered[k] / static_cast<double>(std::max<size_t>(1, maps)));
  std::printf(" %zu of %zu |\n", maps, maps + failed);
}

bool isRotary(const std::string& preset) {
  const auto bench = readBench(resourcesFolder() + "/presets/" + preset + ".bench.json");
  return bench && bench->axis == Axis::rotary;
}

struct Wanted {
  unsigned count = 24, first = 1000;
  std::string results, only, family;
};

/// One rig after the other; those in the results are not done again.
class Study {
 public:
  explicit Study(const Wanted& wanted) : wanted_(wanted) {}

  Result<void> begin() {
    folder_ = std::filesystem::temp_directory_path() / ("breakaway-maps-" + std::to_string(getpid()));
    if (auto made = makeFolder(folder_.string()); !made) return made;
    if (wanted_.results.empty()) return {};
    const auto lines = readWholeLines(wanted_.results);
    if (!lines) return lines.error();
    for (const std::string& line : *lines) {
      if (auto score = MapScore::fromLine(line)) finished_[score->rig] = *score;
    }
    return {};
  }
  ~Study() {
    std::error_code code;
    std::filesystem::remove_all(folder_, code);
  }

  std::string rigFile(const std::string& name, const std::string& text) const {
    const std::string file = (folder_ / (name + ".rig.json")).string();
    return writeFile(file, text) ? file : std::string();
  }
  std::vector<MapScore> scores(const std::vector<Job>& jobs) {
    std::vector<MapScore> all;
    for (const Job& job : jobs) {
      if (!wanted_.only.empty() && job.name != wanted_.only) continue;
      if (!finished_.contains(job.name)) {
        finished_[job.name] = scored(job);
        if (!wanted_.results.empty() && !appendLine(wanted_.results, finished_[job.name].line())) std::exit(1);
      }
      all.push_back(finished_[job.name]);
      print(all.back());
    }
    return all;
  }

 private:
  Wanted wanted_;
  std::filesystem::path folder_;
  std::map<std::string, MapScore> finished_;
};

void printHead() {
  std::printf(
      "friction maps against the truth, in %% of the mean: rms error / Cramer-Rao bound of the rig's sensors (! beyond "
      "3, 3 and 8 %% and 1.5 bounds), bins within the 95 %% interval in %%\n%-20s %-19s%-19s%-19s%-8s noise  static "
      "friction, position torque; rig s, cpu s, missed\n",
      "", " breakaway", " Coulomb", " viscous", "  turns");
}

bool anyFailed(const std::vector<MapScore>& scores) {
  return std::any_of(scores.begin(), scores.end(), [](const MapScore& one) { return !one.failure.empty(); });
}

int soundRigs(Study& study, const Wanted& wanted) {
  std::vector<Job> jobs;
  for (const std::string& preset : presetNames()) {
    if (isRotary(preset)) jobs.push_back({preset, "simulated:" + preset, 1});
  }
  for (unsigned seed = wanted.first; seed < wanted.first + wanted.count; ++seed) {
    const std::string number = std::to_string(seed);
    jobs.push_back(
        {"random " + number, "simulated:" + study.rigFile("random-" + number, RandomRig(seed).text()), seed});
  }
  printHead();
  const auto scores = study.scores(jobs);
  printSummary(scores);
  return anyFailed(scores) ? 1 : 0;
}

/// Coverage family by family: where runs share an error, their scatter doesn't show it.
int families(Study& study, const Wanted& wanted) {
  std::vector<std::pair<MapFamily, std::vector<MapScore>>> done;
  printHead();
  for (const MapFamily& family : mapFamilies()) {
    if (wanted.family != "all" && family.name != wanted.family) continue;
    std::vector<Job> jobs;
    for (unsigned seed = wanted.first; seed < wanted.first + wanted.count; ++seed) {
      const std::string name = family.name + " " + std::to_string(seed);
      jobs.push_back({name, "simulated:" + study.rigFile(name, familyRig(family.name, seed)), seed, family.turns,
                      familyBins(family.name, seed)});
    }
    done.emplace_back(family, study.scores(jobs));
  }
  std::printf(
      "\nBins within the 95 %% interval in %%\n\n| family | breakaway cw | ccw | Coulomb cw | ccw | viscous cw | ccw | "
      "static friction | position torque | maps |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [family, scores] : done) printCoverage(family, scores);
  return done.empty() ? 2 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Friction maps of every rotary preset and of rigs at random, against the truth");
  Wanted wanted;
  app.add_option("count", wanted.count, "rigs at random, of each family")->capture_default_str();
  app.add_option("first", wanted.first, "seed of the first one")->capture_default_str();
  app.add_option("--results", wanted.results, "file of finished lines; rigs in it are not done again");
  app.add_option("--only", wanted.only, "the rig of this name alone");
  std::vector<std::string> names{"all"};
  for (const MapFamily& family : mapFamilies()) names.push_back(family.name);
  app.add_option("--family", wanted.family, "rigs whose runs share an error instead: all, or one kind")
      ->check(CLI::IsMember(names));
  CLI11_PARSE(app, argc, argv);
  Study study(wanted);
  if (auto begun = study.begin(); !begun) {
    std::fprintf(stderr, "%s\n", begun.error().message().c_str());
    return 2;
  }
  return wanted.family.empty() ? soundRigs(study, wanted) : families(study, wanted);
}
