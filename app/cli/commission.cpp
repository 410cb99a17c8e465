#include "commission/commission.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/numbers.h"
#include "base/output_folder.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/into_project.h"
#include "cli/number_range.h"
#include "commission/commission_progress.h"
#include "commission/held_beliefs.h"
#include "commission/motor_file.h"
#include "commission/progress_writer.h"
#include "experiment/abilities.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_truth.h"
#include "firmware_link/transport/open_board.h"
#include "friction/map_json.h"
#include "report/commission_report.h"

namespace breakaway::cli {

namespace {

struct CommissionLine {
  std::string bench, board = "simulated", out, against, project;
  double addedInertia_kg_m2 = 0.0, addedTolerance = 0.005;
  bool motorOnly = false, wiringOnly = false;
  unsigned seed = 1;
  size_t bins = 180, turns = 2;
  double run_s = SweepSettings{}.speedRun_s;
  bool resume = false, anew = false, anyway = false, namesBins = false, namesTurns = false, namesRun = false;
};

/// The bench file that was named, or the one beside a simulated rig.
Result<std::optional<Bench>> readBelief(const CommissionLine& line) {
  std::string file = line.bench;
  if (file.empty() && isSimulated(line.board)) {
    const auto rig = rigFileOf(line.board);
    if (!rig) return rig.error();
    file = benchFileBeside(*rig);
  }
  if (file.empty()) return std::optional<Bench>();
  const auto bench = readBench(file);
  if (!bench) return bench.error();
  return std::optional<Bench>(*bench);
}

BoardRequest requestFor(const CommissionLine& line, const std::optional<Bench>& bench) {
  BoardRequest request{line.board, line.seed};
  if (!bench) return request;
  request.polePairs = bench->polePairs;
  request.countsPerRev = bench->countsPerUnit;
  return request;
}

volatile std::sig_atomic_t interruptAsked = 0;

/// Ctrl-C ends the job in order while this lives: motor off, what is measured kept.
class WatchedInterrupt {
 public:
  WatchedInterrupt() {
    interruptAsked = 0;
    before_ = std::signal(SIGINT, [](int) { interruptAsked = 1; });
  }
  ~WatchedInterrupt() { std::signal(SIGINT, before_); }
  WatchedInterrupt(const WatchedInterrupt&) = delete;
  WatchedInterrupt& operator=(const WatchedInterrupt&) = delete;

 private:
  void (*before_)(int);
};

Error withAdvice(const Error& error, const std::string& folder) {
  if (error.place == contradictionPlace)
    return {error.place, error.fact + "; mend it and begin with --anew, or go on with --resume --anyway"};
  return {error.place, error.fact + "; what was measured is kept in " + folder + ", go on with --resume"};
}

/// Takes what an interrupted job left; clears it away only where that is asked for.
Result<void> beginFolder(const CommissionLine& line, CommissionOptions& options) {
  if (!line.resume && !line.anew && holdsProgress(line.out))
    return Error{line.out, "holds an interrupted job: go on with --resume, or give it up with --anew"};
  if (!line.resume) return removeProgress(line.out);
  auto earlier = readProgress(line.out);
  if (!earlier) return earlier.error();
  if (!line.namesBins) options.sweeps.bins = earlier->sweeps.bins;
  if (!line.namesTurns) options.sweeps.turns = earlier->sweeps.turns;
  if (!line.namesRun) options.sweeps.speedRun_s = earlier->sweeps.speedRun_s;
  options.earlier = std::move(*earlier);
  return {};
}

/// The disc that is mounted, and the motor that it is held against.
Result<void> takeAddedInertia(const CommissionLine& line, Axis axis, CommissionOptions& options) {
  options.addedInertia_kg_m2 = {line.addedInertia_kg_m2, line.addedTolerance * line.addedInertia_kg_m2 / normal95};
  options.motorOnly = line.motorOnly;
  if (line.against.empty()) return {};
  auto against = readMotor(line.against);
  if (!against) return against.error();
  if (against->addedInertia_kg_m2.value == line.addedInertia_kg_m2)
    return Error{line.against, "was measured with the same added inertia, expected one with another"};
  if (against->axis != axis)
    return Error{line.against, "is of a motor on another kind of axis than the board's, expected the same"};
  options.against = std::move(*against);
  return {};
}

std::string remarksOf(const Commission& done) {
  std::string words;
  for (const std::string& remark : done.remarks) words += remark + "\n";
  return words;
}

/// What the job writes at its end, the last file last.
OutputPlan outputOf(const CommissionLine& line) {
  OutputPlan plan{line.out, "commission", {"recordings", "bench.json", "motor.json"}, {line.bench, line.against}};
  if (!line.motorOnly) plan.names.insert(plan.names.end(), {"map.json", "map.csv", "truth.csv", "report.html"});
  return plan;
}

/// Puts the job's files in place with the steps' recordings, which stood beside the progress until now.
Result<void> fill(OutputFolder& out, const std::string& folder,
                  const std::function<Result<void>(const std::string& stage)>& write) {
  const auto all = [&](const std::string& stage) -> Result<void> {
    std::error_code code;
    const std::string recordings = folder + "/progress/recordings";
    if (std::filesystem::exists(recordings, code)) std::filesystem::copy(recordings, stage + "/recordings", code);
    if (code) return Error{stage + "/recordings", "cannot be written: " + code.message()};
    return write(stage);
  };
  return out.fill(all, {"progress"});
}

/// What is left once the motor is known and nothing else was asked for.
Result<Answer> endWithMotor(const Commission& done, const std::string& folder, OutputFolder& out) {
  const auto written = fill(out, folder, [&](const std::string& stage) { return writeIdentification(done, stage); });
  if (!written) return written.error();
  const nlohmann::ordered_json json{
      {"motor", folder + "/motor.json"}, {"bench", folder + "/bench.json"}, {"remarks", done.remarks}};
  return Answer{out.inWords() + motorInWords(done) + "\n" + remarksOf(done) + "Motor: " + folder + "/motor.json\n",
                asText(json)};
}

/// The whole job's files, and what is said of it: the map without its bins.
Result<Answer> endWithMap(const Commission& done, const CommissionLine& line, OutputFolder& out) {
  std::optional<FrictionMap> truth;
  if (isSimulated(line.board)) {
    auto known = trueMap(line.board, done.map);
    if (!known) return known.error();
    truth = std::move(*known);
  }
  const auto written =
      fill(out, line.out, [&](const std::string& stage) { return writeCommission(done, truth, stage); });
  if (!written) return written.error();
  auto json = nlohmann::ordered_json::parse(mapJsonText(done.map));
  json.erase("bins");
  for (const char* name : {"bench", "motor", "map"}) json["files"][name] = line.out + "/" + name + ".json";
  json["remarks"] = done.remarks;
  json["report"] = line.out + "/report.html";
  return Answer{out.inWords() + inWords(done) + "\n" + remarksOf(done) + "Report: " + line.out + "/report.html\n",
                asText(json)};
}

/// What a job that measured nothing has made.
void clearAway(const std::string& folder) {
  if (!removeProgress(folder)) return;
  std::error_code code;
  if (std::filesystem::is_empty(folder, code) && !code) std::filesystem::remove(folder, code);
}

/// The wiring check alone: a sentence each, and no files.
Outcome checkWiring(Drive& drive, CommissionOptions options) {
  options.wiringOnly = true;
  options.keepRecordings = false;
  const auto done = commission(drive, options);
  if (progressIsWatched()) std::fprintf(stderr, "\r\033[K");
  if (!done && done.error().place == contradictionPlace)
    return {1, done.error().message() + "; mend it, or go on with --anyway"};
  if (!done) return {interruptAsked != 0 ? 130 : 1, done.error().message()};
  const auto sentences =
      inWords(*done->wiring, done->sensorZero_A, done->noiseRms_A, done->identity.supply_V, done->identity.axis);
  std::string words;
  for (const std::string& sentence : sentences) words += sentence + "\n";
  const nlohmann::ordered_json json{{"wiring", sentences}, {"remarks", done->remarks}};
  return Result<Answer>(Answer{words + remarksOf(*done), asText(json)});
}

Outcome runCommission(const CommissionLine& line) {
  if (line.out.empty() && !line.wiringOnly)
    return Result<Answer>(Error{"--out", "is missing, expected the folder for the results"});
  if (line.wiringOnly && !line.project.empty())
    return Result<Answer>(Error{"--project", "takes files, but --wiring-only leaves none"});
  auto bench = readBelief(line);
  if (!bench) return Result<Answer>(bench.error());
  auto drive = openBoard(requestFor(line, *bench));
  if (!drive) return Result<Answer>(drive.error());
  if (const std::string why = obstacleTo(Task::commissioning, (*drive)->identity()); !why.empty())
    return Result<Answer>(
        Error{"board " + line.board, "is " + (*drive)->identity().device + ", which can't be commissioned: " + why});
  if (*bench && (**bench).axis != (*drive)->identity().axis)
    return Result<Answer>(Error{line.bench.empty() ? "bench" : line.bench,
                                (**bench).axis == Axis::linear ? "is of a linear axis, but the board turns a rotor"
                                                               : "is of a rotor, but the board moves a linear axis"});
  auto project = openAskedProject(line.project);
  if (!project) return Result<Answer>(project.error());
  CommissionOptions options;
  options.bench = *bench;
  options.rig = options.bench && !options.bench->name.empty() ? options.bench->name : (*drive)->identity().device;
  options.sweeps.bins = line.bins;
  options.sweeps.turns = line.turns;
  if (auto taken = takeAddedInertia(line, (*drive)->identity().axis, options); !taken)
    return Result<Answer>(taken.error());
  options.sweeps.speedRun_s = line.run_s;
  options.anyway = line.anyway;
  if (progressIsWatched()) {
    options.progress = [](double part, const std::string& activity) {
      std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100.0 * part, activity.c_str());
    };
  }
  const WatchedInterrupt interrupt;
  options.interrupted = [] { return interruptAsked != 0; };
  if (line.wiringOnly) return checkWiring(**drive, options);
  auto out = OutputFolder::open(outputOf(line));
  if (!out) return Result<Answer>(out.error());
  if (auto begun = beginFolder(line, options); !begun) return Result<Answer>(begun.error());
  ProgressWriter progress(line.out);
  options.keepProgress = [&](const Commission& known) { return progress.keep(known); };
  options.keepRecording = [&](const std::string& step, const Recording& recording) {
    return writeStep(step, recording, line.out + "/progress");
  };
  auto done = commission(**drive, options);
  if (const auto written = progress.finish(); !written && done) done = written.error();
  const bool kept = progress.wrote();
  if (progressIsWatched()) std::fprintf(stderr, "\r\033[K");
  if (!done && !kept && !line.resume) clearAway(line.out);
  if (!done && !kept) return Result<Answer>(done.error());
  if (!done) return {interruptAsked != 0 ? 130 : 1, withAdvice(done.error(), line.out).message()};
  const auto answer = line.motorOnly ? endWithMotor(*done, line.out, *out) : endWithMap(*done, line, *out);
  return intoProject(
      *project, {.kind = line.motorOnly ? "identification" : "commission", .sources = {line.out}, .only = out->files()},
      answer);
}

}  // namespace

void addCommission(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<CommissionLine>();
  auto* command =
      app.add_subcommand("commission", "Do the whole bench job: identify, home, sweep both ways, map the friction");
  command->add_option(
      "--bench", line->bench,
      "bench file, NAME.bench.json; without it the one beside a simulated rig, or none: then everything is identified");
  command
      ->add_option("--board", line->board,
                   "simulated, simulated:PRESET, simulated:FILE.rig.json, serial:PORT[@BAUD] or tcp:HOST:PORT")
      ->capture_default_str();
  command->add_option(
      "--out", line->out,
      "folder for bench.json, recordings, map.json, map.csv, report.html, and truth.csv of a simulated board; "
      "needed unless --wiring-only");
  addProjectOption(*command, line->project);
  command->add_option("--seed", line->seed, "seed of a simulated board's noise")->capture_default_str();
  auto* bins =
      command->add_option("--bins", line->bins,
                          "bins around the rotor, or over a linear axis' travel; with --resume the interrupted job's");
  bins->capture_default_str()->check(CLI::Range(36, 1440));
  auto* turns = command->add_option(
      "--turns", line->turns,
      "turns of the breakaway sweep each way, or passes over the travel; with --resume the interrupted job's");
  turns->capture_default_str()->check(CLI::Range(1, 20));
  command
      ->add_option("--added-inertia", line->addedInertia_kg_m2,
                   "kg m², of a disc that is mounted on the shaft for this run; kg, of a mass on a linear axis")
      ->check(numberIn(0.0, 1e3));
  command->add_option("--added-tolerance", line->addedTolerance, "relative half width of its 95 % interval")
      ->capture_default_str()
      ->check(numberIn(0.0, 0.5));
  command->add_option("--against", line->against,
                      "motor.json of a run with another added inertia: both together give the torque constant and all "
                      "torques without trusting the current sensor's gain");
  command->add_flag("--motor-only", line->motorOnly,
                    "end once the motor is identified: bench.json and motor.json only");
  command->add_flag("--wiring-only", line->wiringOnly,
                    "only check the wiring, by a few small pulses: a sentence each on what was seen, no files");
  command->add_flag("--anew", line->anew, "give up the interrupted job in the folder, and begin anew");
  command->add_flag("--anyway", line->anyway,
                    "go on where the bench file contradicts the board or what is measured; the results say so");
  auto* run = command->add_option("--run-s", line->run_s,
                                  "seconds at each speed of the velocity sweep; with --resume the interrupted job's");
  run->capture_default_str()->check(numberIn(2.0, 120.0));
  command->add_flag(
      "--resume", line->resume,
      "go on with the interrupted job in the folder: its motor, runs and breakaways are kept, the current "
      "sensor is zeroed and the rotor homed anew");
  command->footer(
      "Examples:\n"
      "  breakaway commission --out c\n"
      "  breakaway commission --bench axis7.bench.json --board serial:ttyACM0 --wiring-only\n"
      "  breakaway commission --bench axis7.bench.json --board serial:ttyACM0 --out c\n"
      "  breakaway commission --board serial:ttyACM0 --out c --resume");
  command->callback([line, bins, turns, run, &chosen] {
    line->namesBins = bins->count() > 0;
    line->namesTurns = turns->count() > 0;
    line->namesRun = run->count() > 0;
    chosen = [line] { return runCommission(*line); };
  });
}

}  // namespace breakaway::cli
