#include "project/run_contents.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "base/atomic_file.h"
#include "base/json_text.h"
#include "base/made.h"
#include "base/sha256.h"
#include "friction/map_export.h"
#include "friction/static_average.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {

using AnyJson = nlohmann::json;

std::string textIn(const AnyJson& json, const char* name) {
  const auto it = json.is_object() ? json.find(name) : json.end();
  return json.is_object() && it != json.end() && it->is_string() ? it->get<std::string>() : std::string();
}

const AnyJson& objectIn(const AnyJson& json, const char* name) {
  static const AnyJson none = AnyJson::object();
  const auto it = json.is_object() ? json.find(name) : json.end();
  return json.is_object() && it != json.end() && it->is_object() ? *it : none;
}

/// The JSON object at `path`, or null: then it is a file like any other.
AnyJson parsed(const std::string& path) {
  const OwnInputs ours;  // it is no input of the run
  const auto text = readFile(path);
  if (!text || jsonFault(*text, path)) return {};
  return AnyJson::parse(*text, nullptr, false);
}

/// "map" of "breakaway.map/1"; empty for what isn't ours.
std::string schemaOf(const AnyJson& json) {
  const std::string schema = textIn(json, "schema");
  const std::string prefix = "breakaway.";
  if (!schema.starts_with(prefix)) return {};
  return schema.substr(prefix.size(), schema.find('/') - prefix.size());
}

/// Every field that is {"value", "ci95" or "std"}.
void takeValues(const AnyJson& json, std::vector<RunValue>& values) {
  for (const auto& [name, one] : json.items()) {
    if (!one.is_object() || !one.contains("value") || !one["value"].is_number()) continue;
    const double value = one["value"];
    if (one.contains("ci95") && one["ci95"].is_array() && one["ci95"].size() == 2 && one["ci95"][0].is_number() &&
        one["ci95"][1].is_number()) {
      values.push_back({name, value, one["ci95"][0], one["ci95"][1]});
    } else if (one.contains("std") && one["std"].is_number()) {
      const Estimate estimate{value, one["std"]};
      values.push_back({name, value, estimate.low95(), estimate.high95()});
    }
  }
}

/// Static friction on average over the map, which its file doesn't name.
void takeStaticAverage(const std::string& path, std::vector<RunValue>& values) {
  const OwnInputs ours;
  const auto map = readMap(path);
  if (!map || map->bins.empty()) return;
  const Estimate mean = staticAverage_Nm(*map);
  values.push_back(
      {map->axis == Axis::linear ? "static_average_N" : "static_average_Nm", mean.value, mean.low95(), mean.high95()});
}

struct Provenance {
  std::set<std::string> runs;
  bool taken = false;
};

void takeMade(const AnyJson& made, Provenance& provenance, ProjectRun& run) {
  const std::string id = textIn(made, "run");
  if (!id.empty()) provenance.runs.insert(id);
  if (provenance.taken || made.empty()) return;
  provenance.taken = true;
  if (const std::string at = textIn(made, "at"); isRunTime(at)) run.at = at;
  run.by = textIn(made, "by");
  run.command = textIn(made, "command");
  const AnyJson& device = objectIn(made, "device");
  run.device = textIn(device, "model");
  run.deviceSerial = textIn(device, "serial_number");
  run.firmware = textIn(device, "firmware");
}

void takeDiagnosis(const AnyJson& json, ProjectRun& run) {
  run.verdict = textIn(json, "verdict");
  takeValues(objectIn(json, "base"), run.values);
  const auto findings = json.find("findings");
  if (findings == json.end() || !findings->is_array()) return;
  for (const AnyJson& one : *findings) {
    const std::string sentence = textIn(one, "sentence");
    run.findings.push_back(textIn(one, "effect") + (sentence.empty() ? "" : ": " + sentence));
  }
}

void takeJson(const AnyJson& json, const std::string& kind, const std::string& path, Provenance& provenance,
              ProjectRun& run) {
  takeMade(objectIn(json, "made"), provenance, run);
  if (kind == "map") {
    takeValues(json, run.values);
    takeStaticAverage(path, run.values);
  } else if (kind == "motor") {
    takeValues(objectIn(json, "motor"), run.values);
    if (run.device.empty()) run.device = textIn(json, "device");
  } else if (kind == "tuning") {
    takeValues(objectIn(json, "motor"), run.values);
  } else if (kind == "diagnosis") {
    takeDiagnosis(json, run);
  } else if (kind == "bench") {
    run.motor = textIn(json, "motor_serial");
  }
}

std::string kindBySuffix(const std::string& path) {
  const std::string suffix = fs::path(path).extension().string();
  if (suffix == ".blocks") return "recording";
  if (suffix == ".html" || suffix == ".pdf") return "report";
  if (suffix == ".svg" || suffix == ".png") return "figure";
  return suffix == ".csv" ? "table" : "file";
}

/// A CSV file is a recording if its header line has a time.
bool isRecording(const std::string& path) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line[0] != '#') return ("," + line + ",").find(",time_s,") != std::string::npos;
  }
  return false;
}

/// What kind of run leaves such files.
std::string kindOfRun(const ProjectRun& run) {
  if (run.file("diagnosis") != nullptr) return "diagnosis";
  if (run.file("tuning") != nullptr) return "tuning";
  if (run.file("map") != nullptr) return "map";
  if (run.file("motor") != nullptr) return "identification";
  if (run.file("recording") != nullptr) return "recording";
  return "files";
}

}  // namespace

std::string motorSerialIn(const std::string& benchFile) {
  return textIn(parsed(benchFile), "motor_serial");
}

std::string kindOfFile(const std::string& path) {
  if (fs::path(path).extension() == ".json") {
    const std::string schema = schemaOf(parsed(path));
    return schema.empty() ? "file" : schema;
  }
  const std::string kind = kindBySuffix(path);
  return kind == "table" && isRecording(path) ? "recording" : kind;
}

Result<ProjectRun> contentsOf(const std::string& folder) {
  ProjectRun run;
  Provenance provenance;
  std::vector<std::string> names;
  std::error_code code;
  for (const auto& one : fs::recursive_directory_iterator(folder, code)) {
    if (one.is_regular_file(code)) names.push_back(one.path().lexically_relative(folder).string());
  }
  if (code) return Error{folder, "cannot be read: " + code.message()};
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    if (name == "run.json") continue;
    const std::string path = folder + "/" + name;
    const auto hash = sha256OfFile(path);
    if (!hash) return hash.error();
    std::string kind;
    if (fs::path(name).extension() == ".json") {
      const AnyJson json = parsed(path);
      kind = schemaOf(json);
      if (!kind.empty()) takeJson(json, kind, path, provenance, run);
      if (kind.empty()) kind = "file";
    } else {
      kind = kindOfFile(path);
    }
    run.files.push_back({name, kind, fs::file_size(path, code), *hash});
  }
  if (provenance.runs.size() > 1)
    return Error{folder, "holds files of " + std::to_string(provenance.runs.size()) + " runs, expected one run's"};
  run.kind = kindOfRun(run);
  return run;
}

}  // namespace breakaway
