#include "commission/commission_progress.h"

#include <fmt/core.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/made.h"
#include "commission/motor_file.h"
#include "commission/strokes_file.h"

namespace breakaway {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr const char* schema = "breakaway.progress/1";
constexpr size_t sumWidth = 5, eventWidth = 16;
constexpr double mostCount = 1e9, mostBins = 1e4, mostTurns = 1e4, mostFiles = 1e4;

std::string stateFile(const std::string& folder) {
  return folder + "/progress/state.json";
}

std::string eventsFile(const std::string& folder) {
  return folder + "/progress/breakaways.json";
}

/// One that was broken off still grows if it is the last.
std::string runFile(const std::string& folder, size_t number, bool brokenOff) {
  return fmt::format("{}/progress/run-{:02}{}.json", folder, number + 1, brokenOff ? "-broken-off" : "");
}

Json rowOf(const AngleBinSums& sums) {
  return {sums.samples, sums.current_A, sums.currentSquared_A2, sums.velocity_rad_per_s, sums.velocitySquared};
}

Json rowsOf(const std::vector<AngleBinSums>& bins) {
  Json rows = Json::array();
  for (const AngleBinSums& sums : bins) rows.push_back(rowOf(sums));
  return rows;
}

std::string runText(const VelocityRun& run) {
  Json blocks = Json::array();
  for (const RunBlock& block : run.blocks) {
    blocks.push_back({{"turns", block.turns},
                      {"start_speed_rad_per_s", block.startSpeed_rad_per_s},
                      {"end_speed_rad_per_s", block.endSpeed_rad_per_s},
                      {"start_wobble_rad_per_s", block.startWobble_rad_per_s},
                      {"end_wobble_rad_per_s", block.endWobble_rad_per_s},
                      {"bins", rowsOf(block.bins)}});
  }
  const Json json{{"schema", schema},
                  {"target_rad_per_s", run.target_rad_per_s},
                  {"turns", run.turns},
                  {"duration_s", run.duration_s},
                  {"middle_s", run.middle_s},
                  {"zero_A", run.zero_A},
                  {"half_span_s", run.halfSpan_s},
                  {"start_rad", run.start_rad},
                  {"bins", rowsOf(run.bins)},
                  {"broken_off", run.brokenOff},
                  {"blocks", blocks}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string eventsText(const std::vector<BreakawayEvent>& events) {
  Json rows = Json::array();
  for (const BreakawayEvent& e : events) {
    rows.push_back({e.way == Way::ccw ? 1 : 0, e.turn, e.bin, e.angle_rad, e.current_A, e.commanded_A,
                    e.commandedMean_A, e.measuredMean_A, e.commandedVariance_A2, e.covariance_A2, e.samples,
                    e.torque_Nm, e.outlier ? 1 : 0, e.time_s, e.zero_A, e.lag_A});
  }
  return Json{{"schema", schema}, {"events", rows}}.dump() + "\n";
}

std::string stateText(const Commission& progress) {
  Json json{{"schema", schema},
            {"device", progress.identity.device},
            {"bins", progress.sweeps.bins},
            {"turns", progress.sweeps.turns},
            {"speed_run_s", progress.sweeps.speedRun_s},
            {"speeds", progress.sweeps.speeds},
            {"highest_rad_per_s", progress.sweeps.highest_rad_per_s},
            {"added_inertia_kg_m2", progress.addedInertia_kg_m2.value},
            {"part", progress.part},
            {"rig_time_s", progress.rigTime_s},
            {"remarks", progress.remarks},
            {"contradictions", progress.contradictions},
            {"runs", progress.runs.size()},
            {"strokes", progress.strokes.size()}};
  if (!progress.identity.serialNumber.empty()) json["serial_number"] = progress.identity.serialNumber;
  if (progress.travel)
    json["travel"] = {{"low_m", progress.travel->low_m},
                      {"high_m", progress.travel->high_m},
                      {"margin_m", progress.travel->margin_m}};
  if (progress.trustedTorqueConstant_Nm_per_A)
    json["trusted_torque_constant_Nm_per_A"] = *progress.trustedTorqueConstant_Nm_per_A;
  if (progress.knows(Known::motor)) {
    Json motor = Json::parse(motorText(progress.identified));
    motor["shown_resistance_ohm"] = progress.shownResistance_ohm;
    motor["expected_cw_A"] = progress.expected_A[0];
    motor["expected_ccw_A"] = progress.expected_A[1];
    json["motor"] = motor;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void checkSchema(JsonObject& root) {
  const std::string found = root.text("schema");
  if (found != schema) root.fault("schema", "is \"" + found + "\", expected \"" + schema + "\"");
}

size_t countOf(JsonObject& object, std::string_view name, double most = mostCount) {
  const double count = object.number(name, Allowed::nonNegative);
  if (count <= most) return static_cast<size_t>(count);
  object.fault(name, "is too large for a count");
  return 0;
}

bool isCount(double value) {
  return value >= 0.0 && value <= mostCount;
}

std::vector<AngleBinSums> sumsIn(JsonObject& object) {
  std::vector<AngleBinSums> sums;
  for (const auto& row : object.rows("bins", sumWidth)) {
    if (!isCount(row[0])) object.fault("bins", "holds a wrong number of samples");
    sums.push_back({isCount(row[0]) ? static_cast<size_t>(row[0]) : 0, row[1], row[2], row[3], row[4]});
  }
  return sums;
}

Result<VelocityRun> readRun(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  checkSchema(*root);
  VelocityRun run{
      root->number("target_rad_per_s"), countOf(*root, "turns"), root->number("duration_s", Allowed::positive),
      root->number("middle_s"),         root->number("zero_A"),  root->number("half_span_s", Allowed::positive),
      root->number("start_rad"),        sumsIn(*root),           {},
      root->flag("broken_off", false)};
  for (JsonObject& block : root->objects("blocks")) {
    run.blocks.push_back({countOf(block, "turns"), block.number("start_speed_rad_per_s"),
                          block.number("end_speed_rad_per_s"), block.number("start_wobble_rad_per_s"),
                          block.number("end_wobble_rad_per_s"), sumsIn(block)});
    if (run.blocks.back().bins.size() != run.bins.size())
      block.fault("bins", "has another length than the whole run's");
  }
  if (const auto done = root->finish(); !done) return done.error();
  return run;
}

BreakawayEvent eventOf(const std::vector<double>& row) {
  BreakawayEvent event;
  event.way = row[0] > 0.0 ? Way::ccw : Way::cw;
  event.turn = static_cast<size_t>(row[1]);
  event.bin = static_cast<size_t>(row[2]);
  event.angle_rad = row[3];
  event.current_A = row[4];
  event.commanded_A = row[5];
  event.commandedMean_A = row[6];
  event.measuredMean_A = row[7];
  event.commandedVariance_A2 = row[8];
  event.covariance_A2 = row[9];
  event.samples = static_cast<size_t>(row[10]);
  event.torque_Nm = row[11];
  event.outlier = row[12] > 0.0;
  event.time_s = row[13];
  event.zero_A = row[14];
  event.lag_A = row[15];
  return event;
}

Result<std::vector<BreakawayEvent>> readEvents(const std::string& path, const Commission& progress) {
  std::error_code code;
  if (!fs::exists(path, code)) return std::vector<BreakawayEvent>{};
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  checkSchema(*root);
  std::vector<BreakawayEvent> events;
  const auto bins = static_cast<double>(progress.sweeps.bins);
  for (const auto& row : root->rows("events", eventWidth)) {
    const bool counts = isCount(row[1]) && isCount(row[10]) && row[2] >= 0.0 && row[2] < bins;
    const double low = progress.travel ? progress.travel->low_m : 0.0;
    const double high = progress.travel ? progress.travel->high_m : turn_rad;
    if (counts && row[3] >= low && row[3] <= high) {
      events.push_back(eventOf(row));
    } else {
      root->fault("events", counts ? "holds a place beyond the turn or the travel"
                                   : "holds a wrong turn, bin or number of samples");
    }
  }
  if (const auto done = root->finish(); !done) return done.error();
  return events;
}

void takeMotor(JsonObject object, Commission& progress) {
  progress.identified = motorIn(object);
  progress.shownResistance_ohm = object.number("shown_resistance_ohm", Allowed::nonNegative);
  progress.expected_A = {object.number("expected_cw_A"), object.number("expected_ccw_A")};
  progress.motor = progress.identified;
  progress.facts.add({Known::windingTest, Known::roughMotor, Known::reversal, Known::bridge, Known::motor});
}

Result<void> writeRun(const VelocityRun& run, const std::string& path) {
  return writeFile(path, withMade(runText(run)));
}

/// What is written of a run stays, but for the one under way.
template <typename Run>
Result<void> writeRuns(const std::vector<Run>& runs, const std::string& folder,
                       std::string (*fileOf)(const std::string&, size_t, bool),
                       Result<void> (*write)(const Run&, const std::string&)) {
  std::error_code code;
  for (size_t k = 0; k < runs.size(); ++k) {
    const std::string file = fileOf(folder, k, runs[k].brokenOff);
    const bool grows = runs[k].brokenOff && k + 1 == runs.size();
    if (!grows && fs::exists(file, code)) continue;
    if (auto written = write(runs[k], file); !written) return written;
  }
  return {};
}

template <typename Run>
Result<std::vector<Run>> readRuns(size_t count, const std::string& folder,
                                  std::string (*fileOf)(const std::string&, size_t, bool),
                                  Result<Run> (*read)(const std::string&)) {
  std::error_code code;
  std::vector<Run> runs;
  for (size_t k = 0; k < count; ++k) {
    const std::string whole = fileOf(folder, k, false);
    auto run = read(fs::exists(whole, code) ? whole : fileOf(folder, k, true));
    if (!run) return run.error();
    runs.push_back(std::move(*run));
  }
  return runs;
}

/// A run that is complete by now, or whose beginning was thrown away.
template <typename Run>
void removeGoneRuns(const std::vector<Run>& runs, const std::string& folder,
                    std::string (*fileOf)(const std::string&, size_t, bool)) {
  std::error_code code;
  for (size_t k = 0; k <= runs.size(); ++k) {
    if (k == runs.size() || !runs[k].brokenOff) fs::remove(fileOf(folder, k, true), code);
  }
}

}  // namespace

Result<void> writeProgress(const Commission& progress, const std::string& folder) {
  if (auto made = makeFolder(folder + "/progress"); !made) return made;
  if (auto written = writeRuns(progress.runs, folder, runFile, writeRun); !written) return written;
  if (auto written = writeRuns(progress.strokes, folder, strokesFile, writeStrokes); !written) return written;
  if (!progress.breakaways.empty()) {
    if (auto written = writeFile(eventsFile(folder), eventsText(progress.breakaways)); !written) return written;
  }
  if (auto written = writeFile(stateFile(folder), withMade(stateText(progress))); !written) return written;
  removeGoneRuns(progress.runs, folder, runFile);
  removeGoneRuns(progress.strokes, folder, strokesFile);
  return {};
}

Result<Commission> readProgress(const std::string& folder) {
  std::error_code code;
  if (!fs::exists(stateFile(folder), code))
    return Error{folder, message("holds no interrupted commissioning to go on from, expected progress/state.json")};
  auto root = JsonObject::fromFile(stateFile(folder));
  if (!root) return root.error();
  checkSchema(*root);
  Commission progress;
  progress.identity.device = root->text("device");
  progress.identity.serialNumber = root->text("serial_number", "");
  progress.sweeps.bins = countOf(*root, "bins", mostBins);
  progress.sweeps.turns = countOf(*root, "turns", mostTurns);
  progress.sweeps.speedRun_s = root->number("speed_run_s", Allowed::positive);
  progress.sweeps.speeds = root->has("speeds") ? countOf(*root, "speeds", mostFiles) : 0;
  progress.sweeps.highest_rad_per_s = root->number("highest_rad_per_s", 0.0, Allowed::nonNegative);
  progress.trustedTorqueConstant_Nm_per_A = root->optionalNumber("trusted_torque_constant_Nm_per_A", Allowed::positive);
  progress.addedInertia_kg_m2.value = root->number("added_inertia_kg_m2", 0.0, Allowed::nonNegative);
  progress.part = countOf(*root, "part");
  progress.rigTime_s = root->number("rig_time_s", Allowed::nonNegative);
  for (const std::string& remark : root->texts("remarks")) progress.remarks.emplace_back(remark);
  for (const std::string& one : root->texts("contradictions")) progress.contradictions.emplace_back(one);
  const size_t runs = countOf(*root, "runs", mostFiles);
  const size_t strokes = root->has("strokes") ? countOf(*root, "strokes", mostFiles) : 0;
  if (root->has("travel")) {
    JsonObject travel = root->object("travel");
    progress.travel = Travel{travel.number("low_m"), travel.number("high_m"), travel.number("margin_m")};
  }
  if (root->has("motor")) takeMotor(root->object("motor"), progress);
  if (const auto done = root->finish(); !done) return done.error();
  auto turned = readRuns<VelocityRun>(runs, folder, runFile, readRun);
  if (!turned) return turned.error();
  progress.runs = std::move(*turned);
  auto went = readRuns<TravelRun>(strokes, folder, strokesFile, readStrokes);
  if (!went) return went.error();
  progress.strokes = std::move(*went);
  auto events = readEvents(eventsFile(folder), progress);
  if (!events) return events.error();
  progress.breakaways = std::move(*events);
  return progress;
}

bool holdsProgress(const std::string& folder) {
  std::error_code code;
  return fs::exists(stateFile(folder), code);
}

Result<void> removeProgress(const std::string& folder) {
  std::error_code code;
  fs::remove_all(folder + "/progress", code);
  if (code) return Error{folder + "/progress", "cannot be removed: " + code.message()};
  return {};
}

}  // namespace breakaway
