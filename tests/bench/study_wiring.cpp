// Every fault of a rig's wiring at the start, in every procedure and in the last one, on three presets; and sound rigs
// at random, which must be left alone. ./dev bench wiring [--help]
#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "base/line_log.h"
#include "bench/wiring_runs.h"
#include "firmware_link/simulated_board.h"
#include "support/random_rig.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

constexpr double inStep = 0.4;  // of its time, at which the fault comes

struct Options {
  std::vector<std::string> presets{"servo", "geared", "linear"};
  std::vector<std::string> faults;  ///< their names; empty: all
  std::string results = "build/wiring.jsonl";
  unsigned seed = 3;  ///< of the noise on the presets' rigs
  unsigned sound = 200, soundFrom = 1;

  bool tries(const WiringFault& fault) const {
    return faults.empty() || std::find(faults.begin(), faults.end(), fault.name) != faults.end();
  }
  /// Of a run of that seed; the usual one's isn't told.
  std::string key(const std::string& text) const { return seed == 3 ? text : text + fmt::format(", seed {}", seed); }
};

/// What is known of a run already, by its key; appended to as runs are made.
class Log {
 public:
  explicit Log(std::string path) : path_(std::move(path)) {
    const auto lines = readWholeLines(path_);
    if (!lines) return;
    for (const std::string& line : *lines) {
      const auto json = nlohmann::json::parse(line, nullptr, false);
      if (json.contains("key")) known_[json["key"]] = json;
    }
  }
  template <typename Make>
  nlohmann::json once(const std::string& key, const Make& make) {
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    nlohmann::json json = make();
    json["key"] = key;
    if (const auto kept = appendLine(path_, json.dump()); !kept)
      std::fprintf(stderr, "%s\n", kept.error().message().c_str());
    return json;
  }

 private:
  std::string path_;
  std::map<std::string, nlohmann::json> known_;
};

nlohmann::json asJson(const WiringRun& run) {
  return {{"status", run.status},         {"words", run.words}, {"tripped_s", run.tripped_s},
          {"beyond_rad", run.beyond_rad}, {"named", run.named}, {"beyond_rad_per_s", run.beyond_rad_per_s}};
}

/// The worst of a row's runs.
struct Worst {
  int runs = 0, named = 0, ended = 0, late = 0;
  double beyond_rad = 0.0, beyond_rad_per_s = 0.0, tripped_s = 0.0;

  void take(const nlohmann::json& run, double tenth) {
    ++runs;
    named += run["named"].get<bool>() ? 1 : 0;
    ended += run["status"].get<int>() != 0 ? 1 : 0;
    const double travel = run["beyond_rad"], time_s = run["tripped_s"];
    late += travel > tenth && time_s > 0.1 ? 1 : 0;
    beyond_rad = std::max(beyond_rad, travel);
    beyond_rad_per_s = std::max(beyond_rad_per_s, run["beyond_rad_per_s"].get<double>());
    tripped_s = std::max(tripped_s, time_s);
  }
};

void printRow(const std::string& preset, const WiringFault& fault, const char* when, const Worst& worst) {
  const bool linear = preset == "linear";
  const double per = linear ? 1e3 : 1.0;
  std::printf("| %s | %s | %s | %.3g %s | %.3g %s | %.2f s | %d of %d | %d of %d |\n", preset.c_str(),
              fault.text().c_str(), when, per * worst.beyond_rad, linear ? "mm" : "rad", per * worst.beyond_rad_per_s,
              linear ? "mm/s" : "rad/s", worst.tripped_s, worst.ended, worst.runs, worst.named, worst.runs);
  std::fflush(stdout);
}

void studyFaults(const Options& options, Log& log) {
  std::printf(
      "| preset | fault | from | beyond, at most | speed beyond | time to the trip | status 1 | cause named |\n"
      "|---|---|---|---|---|---|---|---|\n");
  Worst all;
  std::vector<std::string> odd;
  for (const std::string& preset : options.presets) {
    const double tenth = preset == "linear" ? 0.008 : 0.628;
    const std::vector<StepSpan> steps = soundSteps(preset, options.seed);
    for (const WiringFault& fault : wiringFaults(preset)) {
      if (!options.tries(fault)) continue;
      const auto at = [&](double from_s) {
        return log.once(options.key(fmt::format("{}, {}, {:.2f}", preset, fault.text(), from_s)),
                        [&] { return asJson(runWith(fault, preset, from_s, steps, options.seed)); });
      };
      Worst first, middle, last;
      for (size_t k = 0; k <= (fault.atStartOnly ? 0 : steps.size()); ++k) {
        const double from_s =
            k == 0 ? 0.0 : steps[k - 1].begin_s + inStep * (steps[k - 1].end_s - steps[k - 1].begin_s);
        const auto run = at(from_s);
        (k == 0 ? first : k < steps.size() ? middle : last).take(run, tenth);
        all.take(run, tenth);
        if (!run["named"] || (run["status"] == 0 && !fault.may) ||
            (run["beyond_rad"] > tenth && run["tripped_s"] > 0.1))
          odd.push_back(fmt::format("{} | {} | {} | status {} | {:.3g} beyond, {:.3g} s | {}", preset, fault.text(),
                                    k == 0 ? "start" : steps[k - 1].name, run["status"].get<int>(),
                                    run["beyond_rad"].get<double>(), run["tripped_s"].get<double>(),
                                    run["words"].get<std::string>()));
      }
      printRow(preset, fault, "the start", first);
      if (fault.atStartOnly) continue;
      printRow(preset, fault, "each procedure", middle);
      printRow(preset, fault, "the last", last);
    }
  }
  std::printf("\ncause named in %d of %d runs, beyond a tenth of a turn (8 mm) and 100 ms in %d\n", all.named, all.runs,
              all.late);
  for (const std::string& one : odd) std::printf("odd: %s\n", one.c_str());
}

/// At the start, over a pseudo terminal.
void studyTerminal(const Options& options, Log& log) {
  const std::string preset = "servo";
  std::printf("| fault, over a pseudo terminal | time to the trip | status | words |\n|---|---|---|---|\n");
  for (const WiringFault& fault : wiringFaults(preset)) {
    if (!options.tries(fault)) continue;
    if (fault.may && !fault.atStartOnly) continue;  // the whole job would be made
    const auto run = log.once(options.key("terminal, " + fault.text()),
                              [&] { return asJson(runOverTerminal(fault, preset, 0.0, options.seed)); });
    std::printf("| %s | %.2f s | %d | %s%s |\n", fault.text().c_str(), run["tripped_s"].get<double>(),
                run["status"].get<int>(), run["named"].get<bool>() ? "" : "(another cause) ",
                run["words"].get<std::string>().c_str());
    std::fflush(stdout);
  }
}

/// Whole short jobs on sound rigs.
void studySound(const Options& options, Log& log) {
  unsigned refused = 0;
  for (unsigned seed = options.soundFrom; seed < options.soundFrom + options.sound; ++seed) {
    const auto run = log.once(fmt::format("sound, {}", seed), [seed] {
      const TemporaryFolder folder;
      auto drive = openDrive("simulated:" + folder.write("r.rig.json", RandomRig(seed).text(seed % 2 == 0)), seed);
      if (!drive) qFatal("%s", drive.error().message().c_str());
      const auto done = commission(**drive, shortJob({}));
      return nlohmann::json{{"words", done ? "" : done.error().message()}};
    });
    const std::string words = run["words"];
    if (words.empty()) continue;
    ++refused;
    std::printf("sound rig %u: %s\n", seed, words.c_str());
  }
  std::printf("sound rigs at random: %u of %u ended early\n", refused, options.sound);
}

}  // namespace

int main(int count, char** words) {
  const QCoreApplication application(count, words);
  Options options;
  bool soundOnly = false, terminal = false;
  CLI::App app("Faults of a rig's wiring, and sound rigs", "wiring");
  app.add_option("--preset", options.presets, "presets to try");
  app.add_option("--fault", options.faults, "faults to try, by their names; otherwise all");
  app.add_option("--seed", options.seed, "of the noise on the presets' rigs")->capture_default_str();
  app.add_option("--results", options.results, "where runs are kept, and gone on from")->capture_default_str();
  app.add_option("--sound", options.sound, "sound rigs at random")->capture_default_str();
  app.add_option("--sound-from", options.soundFrom, "seed of the first of them")->capture_default_str();
  app.add_flag("--sound-only", soundOnly, "no faults");
  app.add_flag("--terminal", terminal, "the preset servo over a pseudo terminal, only");
  CLI11_PARSE(app, count, words);
  Log log(options.results);
  if (terminal) {
    studyTerminal(options, log);
    return 0;
  }
  if (!soundOnly) studyFaults(options, log);
  studySound(options, log);
  return 0;
}
