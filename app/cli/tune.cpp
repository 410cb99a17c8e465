#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/numbers.h"
#include "base/output_folder.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/into_project.h"
#include "cli/number_range.h"
#include "motor/beliefs.h"
#include "report/tuning_report.h"
#include "stability/bench_loop.h"

namespace breakaway::cli {

namespace {

constexpr double worthSaying = 0.02;                // of the stall current, in the current's noise
constexpr double perHalfInterval = 1.0 / normal95;  // a standard error per half of a 95 % interval

struct TuneLine {
  std::string bench, stiffness = "medium", out, project;
  BoardTiming timing;
  InnerLoopOptions inner;
  bool anyway = false;
  double inertiaError_percent = 5.0, torqueConstantError_percent = 2.7, currentNoise_A = 0.018, currentLimit_A = 0.0;
};

Estimate within(double value, double percent) {
  return {value, 0.01 * percent * perHalfInterval * value};
}

/// A file that contradicts itself is refused, or keeps the remark.
Result<void> holdToItself(const TuneLine& line, Bench& bench) {
  const auto contradiction = selfContradictionOf(bench);
  if (!contradiction) return {};
  if (!line.anyway)
    return Error{line.bench + ", field motor." + contradiction->place, contradiction->fact + "; --anyway goes on"};
  bench.remarks.push_back("In spite of a contradiction: " + contradiction->message() + ".");
  return {};
}

/// The current's noise against the limit, or where none is given against what the standing motor draws at full supply.
struct NoiseShare {
  double noise_A = 0.0, most_A = 0.0;
  bool given = false;
  double share() const { return most_A > 0.0 ? noise_A / most_A : 0.0; }
  std::string inWords() const {
    return fmt::format("the current's noise, {:.3g} A rms, is {:.3g} % of {} of {:.3g} A", noise_A, 100.0 * share(),
                       given ? "the current limit" : "the stall current U/R", most_A);
  }
};

NoiseShare noiseShareOf(const TuningStudy& study, const Bench& bench) {
  NoiseShare noise{study.tuning.noise.currentReference_A, study.loop.settings.current_limit_A, true};
  if (noise.most_A > 0.0 || !bench.supply_V || !bench.motor.resistance_ohm) return noise;
  return {noise.noise_A, *bench.supply_V / *bench.motor.resistance_ohm, false};
}

Result<Answer> runTune(const TuneLine& line) {
  auto project = openAskedProject(line.project);
  if (!project) return project.error();
  auto bench = readBench(line.bench);
  if (!bench) return bench.error();
  if (auto held = holdToItself(line, *bench); !held) return held.error();
  auto out = OutputFolder::open({line.out,
                                 "tune",
                                 {"bench.json", "root_locus.csv", "response.csv", "noise.csv", "speed_observer.csv",
                                  "current_loop.csv", "figures", "tuning.json"},
                                 {line.bench}});
  if (!out) return out.error();
  auto loop = loopOfBench(*bench, line.timing);
  if (!loop) return Error{line.bench + ", " + loop.error().place, loop.error().fact};
  if (line.currentLimit_A > 0.0) loop->settings.current_limit_A = line.currentLimit_A;
  AutoTuningOptions options;
  options.stiffness = *stiffnessNamed(line.stiffness);
  options.noise = {roundingRms_rad(bench->count()), line.currentNoise_A};
  InnerLoopOptions inner = line.inner;
  inner.supply_V = bench->supply_V.value_or(0.0);
  auto study =
      studyTuning(*loop, within(loop->motor.inertia_kg_m2, line.inertiaError_percent),
                  within(loop->motor.torqueConstant_Nm_per_A, line.torqueConstantError_percent), options, inner);
  if (!study) return Error{line.bench + ", " + study.error().place, study.error().fact};
  study->axis = bench->axis;
  const NoiseShare noise = noiseShareOf(*study, *bench);
  if (noise.share() > 1.0 && !line.anyway)
    return Error{line.bench, noise.inWords() + "; check inertia, constants and encoder; --anyway goes on"};
  if (noise.share() > 1.0) bench->remarks.push_back("In spite of noise: " + noise.inWords() + ".");
  const auto written = out->fill([&](const std::string& folder) { return writeTuning(*study, *bench, folder); });
  if (!written) return written.error();
  std::string words = out->inWords() + inWords(*study) + "\n";
  if (!bench->countsPerUnit)
    words += "The bench file has no encoder." + std::string(motorNames(bench->axis).counts) +
             ", so the noise is the current sensor's alone.\n";
  if (!noise.given && noise.share() > worthSaying) words += "No current limit is given: " + noise.inWords() + ".\n";
  for (const std::string& remark : bench->remarks) words += remark + "\n";
  auto json = nlohmann::ordered_json::parse(tuningJson(*study, bench->name));
  if (!bench->remarks.empty()) json["remarks"] = bench->remarks;
  json["tuning"] = line.out + "/tuning.json";
  return intoProject(*project, {.sources = {line.out}, .only = out->files()},
                     Answer{words + "Tuning: " + line.out + "/tuning.json\n", asText(json)});
}

}  // namespace

void addTune(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<TuneLine>();
  auto* command =
      app.add_subcommand("tune", "Tune velocity and position loop, with margins that hold for the motor's doubt");
  command->add_option("--bench", line->bench, "bench file with the identified motor, NAME.bench.json")->required();
  command->add_option("--stiffness", line->stiffness, "how much of the margins to spend")
      ->capture_default_str()
      ->check(CLI::IsMember({"soft", "medium", "stiff"}));
  command->add_option("--tick-s", line->timing.tick_s, "the board's control tick in s")
      ->capture_default_str()
      ->check(numberIn(1e-6, 0.1));
  command
      ->add_option("--delay-ticks", line->timing.delay_ticks,
                   "whole ticks from a sample until its command acts; 0 for the simulated board")
      ->capture_default_str()
      ->check(CLI::Range(0, 20));
  command->add_option("--inertia-error", line->inertiaError_percent, "half of the inertia's 95 % interval in percent")
      ->capture_default_str()
      ->check(numberIn(0.0, 99.0));
  command
      ->add_option("--torque-constant-error", line->torqueConstantError_percent,
                   "half of the torque constant's 95 % interval in percent")
      ->capture_default_str()
      ->check(numberIn(0.0, 99.0));
  command->add_option("--current-noise-A", line->currentNoise_A, "rms noise of the current's measurement in A")
      ->capture_default_str()
      ->check(numberIn(0.0, 1e9));
  command
      ->add_option("--current-limit-A", line->currentLimit_A,
                   "current limit in A; 0: the bench file's. The current's noise stays within 1, 2 or 5 % of it")
      ->capture_default_str()
      ->check(numberIn(0.0, 1e9));
  command
      ->add_option("--velocity-bandwidth", line->inner.observer_rad_per_s,
                   "of the board's speed observer in rad/s; 0: chosen so that the shaft yields least to a load")
      ->capture_default_str()
      ->check(numberIn(0.0, 1e9));
  command
      ->add_option("--current-bandwidth", line->inner.current_rad_per_s,
                   "of the board's current loop in rad/s; 0: chosen, as fast as its margins and noise let it be")
      ->capture_default_str()
      ->check(numberIn(0.0, 1e9));
  command->add_flag("--board-bandwidths", line->inner.asBoards,
                    "instead of choosing these two, take what Breakaway's own boards have, 400 and 300 rad/s at 5 kHz");
  command->add_flag(
      "--anyway", line->anyway,
      "tune where the bench file contradicts itself or the noise is beyond the current; bench.json says so");
  command
      ->add_option("--out", line->out,
                   "folder for tuning.json, bench.json with the controller, root_locus.csv, response.csv, noise.csv, "
                   "figures")
      ->required();
  addProjectOption(*command, line->project);
  command->footer(
      "Examples:\n"
      "  breakaway tune --bench c/bench.json --out t\n"
      "  breakaway tune --bench c/bench.json --stiffness stiff --out t --json");
  command->callback([line, &chosen] { chosen = [line] { return runTune(*line); }; });
}

}  // namespace breakaway::cli
