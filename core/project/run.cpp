#include "project/run.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/made.h"

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* runSchema = "breakaway.run/1";
constexpr double mostBytes = 9e15;  // whole numbers that a double holds

struct TextField {
  const char* name;
  std::string ProjectRun::*text;
};
constexpr TextField textFields[] = {
    {"id", &ProjectRun::id},
    {"kind", &ProjectRun::kind},
    {"name", &ProjectRun::name},
    {"remark", &ProjectRun::remark},
    {"motor", &ProjectRun::motor},
    {"device", &ProjectRun::device},
    {"at", &ProjectRun::at},
    {"by", &ProjectRun::by},
    {"command", &ProjectRun::command},
    {"verdict", &ProjectRun::verdict},
    {"firmware", &ProjectRun::firmware},
    {"device_serial_number", &ProjectRun::deviceSerial},
};

}  // namespace

const RunFile* ProjectRun::file(std::string_view fileKind) const {
  const auto it = std::find_if(files.begin(), files.end(), [&](const RunFile& one) { return one.kind == fileKind; });
  return it == files.end() ? nullptr : &*it;
}

const RunValue* ProjectRun::value(std::string_view valueName) const {
  const auto it =
      std::find_if(values.begin(), values.end(), [&](const RunValue& one) { return one.name == valueName; });
  return it == values.end() ? nullptr : &*it;
}

const char* wordOf(RunState state) {
  return state == RunState::whole ? "whole" : state == RunState::recording ? "recording" : "cut";
}

std::string runText(const ProjectRun& run) {
  Json json{{"schema", runSchema}};
  for (const TextField& field : textFields) json[field.name] = run.*field.text;
  json["state"] = wordOf(run.state);
  json["findings"] = run.findings;
  json["values"] = Json::array();
  for (const RunValue& one : run.values)
    json["values"].push_back({{"name", one.name}, {"value", one.value}, {"low", one.low}, {"high", one.high}});
  json["files"] = Json::array();
  for (const RunFile& one : run.files)
    json["files"].push_back({{"path", one.path}, {"kind", one.kind}, {"bytes", one.bytes}, {"sha256", one.sha256}});
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool isRunTime(std::string_view at) {
  constexpr std::string_view form = "0000-00-00T00:00:00";
  if (at.size() <= form.size() || at.back() != 'Z') return false;
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (size_t k = 0; k < form.size(); ++k) {
    if (isDigit(form[k]) ? !isDigit(at[k]) : at[k] != form[k]) return false;
  }
  const std::string_view fraction = at.substr(form.size(), at.size() - form.size() - 1);
  return fraction.empty() ||
         (fraction.size() > 1 && fraction.front() == '.' && std::all_of(fraction.begin() + 1, fraction.end(), isDigit));
}

std::string folderFor(const ProjectRun& run) {
  const auto inName = [](const std::string& text, std::string_view more) {
    std::string name;
    for (const char c : text)
      name += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || more.find(c) != std::string_view::npos ? c : '_';
    return name;
  };
  std::string at = run.at;
  std::erase(at, ':');
  return "runs/" + inName(at, "TZ-.") + "-" + inName(run.kind, "") + "-" + run.id;
}

Result<void> writeRunFile(const ProjectRun& run, const std::string& folder) {
  return writeFile(folder + "/run.json", withMade(runText(run)));
}

Result<ProjectRun> runOnDisk(const std::string& project, const std::string& folder) {
  const OwnInputs ours;  // no input of the run
  const std::string path = project + "/" + folder + "/run.json";
  const auto text = readFile(path);
  if (!text) return text.error();
  auto run = readRunText(*text, path);
  if (run) run->folder = folder;
  return run;
}

Result<ProjectRun> readRunText(const std::string& text, const std::string& place) {
  auto root = JsonObject::fromText(text, place);
  if (!root) return root.error();
  if (const std::string found = root->text("schema"); found != runSchema)
    root->fault("schema", "is \"" + found + "\", expected \"" + runSchema + "\"");
  ProjectRun run;
  for (const TextField& field : textFields) run.*field.text = root->text(field.name);
  const std::string state = root->text("state");
  if (state != "whole" && state != "recording" && state != "cut")
    root->fault("state", "is \"" + state + "\", expected whole, recording or cut");
  run.state = state == "cut" ? RunState::cut : state == "recording" ? RunState::recording : RunState::whole;
  run.findings = root->texts("findings");
  for (JsonObject& one : root->objects("values"))
    run.values.push_back({one.text("name"), one.number("value"), one.number("low"), one.number("high")});
  for (JsonObject& one : root->objects("files")) {
    const double bytes = one.number("bytes", Allowed::nonNegative);
    if (bytes > mostBytes) one.fault("bytes", "is too large for a file");
    run.files.push_back({one.text("path"), one.text("kind"), bytes > mostBytes ? 0 : static_cast<std::uint64_t>(bytes),
                         one.text("sha256")});
  }
  if (run.id.empty()) root->fault("id", "is empty, expected the run's identifier");
  if (const auto done = root->finish(); !done) return done.error();
  return run;
}

}  // namespace breakaway
