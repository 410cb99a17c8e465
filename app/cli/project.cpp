// A project: what it holds, one of its runs, two of them side by side, and whether all is as it should be.
#include "project/project.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/output_folder.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/into_project.h"
#include "commission/unfinished_job.h"
#include "draw/html_report.h"
#include "report/run_comparison.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ProjectLine {
  std::string action, folder, out;
  std::vector<std::string> words;  ///< runs, or what is put in
  RunFilter filter;
  NewRun added;
  bool history = false;
};

std::string wordsOf(const ProjectRun& run) {
  std::string more = run.verdict.empty() ? std::string() : "  " + run.verdict;
  if (run.state != RunState::whole) more += std::string("  ") + wordOf(run.state);
  if (!run.name.empty()) more += "  " + run.name;
  if (!run.remark.empty()) more += "  (" + run.remark + ")";
  return fmt::format("{}  {:<20}  {:<15} {:<12}{}\n", run.id, run.at, run.kind, run.motor.empty() ? "-" : run.motor,
                     more);
}

Json jsonOf(const Project& project, const ProjectRun& run) {
  Json json = Json::parse(runText(run));
  json.erase("schema");
  json["folder"] = project.folder() + "/" + run.folder;
  return json;
}

/// A run as a list has it: without what only its own file holds.
Json lineOf(const Project& project, const ProjectRun& run) {
  Json json = jsonOf(project, run);
  for (const char* name : {"files", "values", "findings", "by", "firmware"}) json.erase(name);
  return json;
}

/// What the project's sweeps have measured that is no map yet.
struct Unfinished {
  std::string words;
  Json json = Json::array();
  std::vector<std::string> faults;
};

/// Of a board with this name, or of all.
Unfinished unfinishedOf(const Project& project, const std::string& device = {}) {
  Unfinished all;
  for (const UnfinishedEntry& one : unfinishedIn(unfinishedPlace(project.folder()))) {
    if (!one.known) {
      all.faults.push_back(one.known.error().message());
      continue;
    }
    const Commission& known = *one.known;
    if (!device.empty() && known.identity.device != device && known.identity.serialNumber != device) continue;
    all.words += fmt::format("{}  {:<20}  {:<15} {}: {}{}\n", "unfinished", one.at, "commission",
                             boardName(known.identity), howFar(known).english(), one.held ? "; under way" : "");
    all.json.push_back({{"folder", one.folder},
                        {"at", one.at},
                        {"kind", "commission"},
                        {"device", known.identity.device},
                        {"device_serial_number", known.identity.serialNumber},
                        {"part", known.part},
                        {"speeds", known.runs.size() + known.strokes.size()},
                        {"speeds_broken_off", speedsBrokenOff(known)},
                        {"breakaways", known.breakaways.size()},
                        {"breakaways_asked", 2 * known.sweeps.bins * known.sweeps.turns},
                        {"under_way", one.held}});
  }
  return all;
}

std::string valueText(const RunValue& value) {
  return fmt::format("{} ({} to {})", numberText(value.value), numberText(value.low), numberText(value.high));
}

/// The maps and what the diagnoses found, the oldest first: as lines, and into `json`.
Result<std::string> mapsAndFindings(const Project& project, const RunFilter& filter, Json& json) {
  auto runs = project.index().list(filter);
  if (!runs) return runs.error();
  std::reverse(runs->begin(), runs->end());
  std::string maps, findings;
  json["maps"] = json["findings"] = Json::array();
  for (const ProjectRun& listed : *runs) {
    const auto run = project.index().find(listed.folder);
    if (!run) return run.error();
    const std::string line = fmt::format("  {:<20}  {}  ", run->at, run->id);
    if (const RunFile* map = run->file("map"); map != nullptr) {
      const std::string path = project.pathOf(*run, map->path);
      maps += line + path + "\n";
      json["maps"].push_back({{"at", run->at}, {"run", run->id}, {"path", path}});
    }
    if (run->file("diagnosis") == nullptr) continue;
    findings += line + run->verdict + "\n";
    for (const std::string& one : run->findings) findings += "    " + one + "\n";
    json["findings"].push_back(
        {{"at", run->at}, {"run", run->id}, {"verdict", run->verdict}, {"findings", run->findings}});
  }
  if (!maps.empty()) maps.insert(0, "maps\n");
  if (!findings.empty()) findings.insert(0, "findings\n");
  return maps + findings;
}

Result<Answer> history(const Project& project, const RunFilter& filter, std::string words) {
  const auto values = project.index().history(filter);
  if (!values) return values.error();
  Json json{{"project", project.folder()}, {"motor", filter.motor}, {"values", Json::array()}};
  std::string name;
  for (const ValueOfRun& one : *values) {
    if (one.value.name != name) words += (name = one.value.name) + "\n";
    words += fmt::format("  {:<20}  {}  {}\n", one.at, one.runId, valueText(one.value));
    json["values"].push_back({{"name", one.value.name},
                              {"at", one.at},
                              {"run", one.runId},
                              {"value", one.value.value},
                              {"ci95", {one.value.low, one.value.high}}});
  }
  const auto more = mapsAndFindings(project, filter, json);
  if (!more) return more.error();
  return Answer{words + *more, asText(json)};
}

Result<Answer> list(const Project& project, const ProjectLine& line) {
  if (line.history) return history(project, line.filter, saidBy(project));
  const auto runs = project.index().list(line.filter);
  if (!runs) return runs.error();
  const auto motors = project.index().motors();
  if (!motors) return motors.error();
  Json json{
      {"project", project.folder()}, {"runs", Json::array()}, {"motors", Json::array()}, {"said", project.said()}};
  std::string words = saidBy(project);
  for (const ProjectRun& run : *runs) {
    words += wordsOf(run);
    json["runs"].push_back(lineOf(project, run));
  }
  for (const auto& [motor, count] : *motors) json["motors"].push_back({{"motor", motor}, {"runs", count}});
  const Unfinished unfinished = unfinishedOf(project, line.filter.device);
  words += unfinished.words;
  json["unfinished"] = unfinished.json;
  words += fmt::format("{}: {} runs, {} motors\n", project.folder(), runs->size(), motors->size());
  return Answer{words, asText(json)};
}

Result<Answer> show(const Project& project, const ProjectLine& line) {
  if (line.words.size() != 1) return Error{"show", "expected one run: an identifier, a name, a date or last"};
  const auto run = project.index().find(line.words[0]);
  if (!run) return run.error();
  std::string words = saidBy(project) + wordsOf(*run);
  if (!run->device.empty())
    words += "board: " + run->device + (run->deviceSerial.empty() ? "" : " (" + run->deviceSerial + ")") + "\n";
  if (!run->command.empty()) words += "made by: " + run->command + "\n";
  for (const RunValue& one : run->values) words += one.name + ": " + valueText(one) + "\n";
  for (const std::string& one : run->findings) words += "found: " + one + "\n";
  for (const RunFile& one : run->files) words += fmt::format("{:<12} {}\n", one.kind, project.pathOf(*run, one.path));
  const Unfinished unfinished = run->device.empty() ? Unfinished{} : unfinishedOf(project, run->device);
  Json json = jsonOf(project, *run);
  json["unfinished"] = unfinished.json;
  return Answer{words + unfinished.words, asText(json)};
}

Result<Answer> add(Project& project, const ProjectLine& line) {
  NewRun added = line.added;
  added.sources = line.words;
  if (added.sources.empty()) return Error{"add", "expected files or folders to put in"};
  const auto run = project.add(added);
  if (!run) return run.error();
  return Answer{saidBy(project) + wordsOf(*run) + "Project: " + project.folder() + ", run " + run->id + "\n",
                asText(jsonOf(project, *run))};
}

Result<Answer> note(Project& project, const ProjectLine& line) {
  if (line.words.size() != 1) return Error{"note", "expected one run: an identifier, a name, a date or last"};
  const auto given = [](const std::string& text) { return text.empty() ? std::nullopt : std::optional(text); };
  const auto run =
      project.annotate(line.words[0], {given(line.added.name), given(line.added.remark), given(line.added.motor)});
  if (!run) return run.error();
  return Answer{saidBy(project) + wordsOf(*run), asText(jsonOf(project, *run))};
}

Result<Answer> compare(const Project& project, const ProjectLine& line) {
  if (line.words.size() != 2) return Error{"compare", "expected two runs, each an identifier, a name, a date or last"};
  const auto one = project.index().find(line.words[0]), other = project.index().find(line.words[1]);
  if (!one) return one.error();
  if (!other) return other.error();
  const auto comparison = compareRuns(project, *one, *other);
  if (!comparison) return comparison.error();
  const Answer answer{saidBy(project) + inWords(*comparison), comparisonJson(*comparison)};
  if (line.out.empty()) return answer;
  auto out = OutputFolder::open({line.out, "project", {"report.html", "figures", "comparison.json"}, {}});
  if (!out) return out.error();
  const auto written = out->fill([&](const std::string& folder) { return writeComparison(*comparison, folder); });
  if (!written) return written.error();
  return Answer{out->inWords() + answer.words + "Report: " + line.out + "/report.html\n", answer.json};
}

Result<Answer> rebuild(Project& project) {
  std::vector<Message> said = project.said();
  if (auto done = project.index().rebuild(said); !done) return done.error();
  const auto runs = project.index().list({});
  if (!runs) return runs.error();
  std::string words;
  for (const Message& one : said) words += one.english() + "\n";
  return Answer{words + fmt::format("{}: index made from {} runs\n", project.folder(), runs->size()),
                asText(Json{{"project", project.folder()}, {"runs", runs->size()}, {"said", said}})};
}

Result<Answer> check(const Project& project) {
  auto faults = project.check();
  if (!faults) return faults.error();
  const Unfinished unfinished = unfinishedOf(project);
  faults->lines.insert(faults->lines.end(), unfinished.faults.begin(), unfinished.faults.end());
  std::string words = saidBy(project) + unfinished.words;
  for (const std::string& one : faults->lines) words += one + "\n";
  words +=
      fmt::format("{}: {} runs, {} files, {}\n", project.folder(), faults->runs, faults->files,
                  faults->lines.empty() ? "all as they should be" : fmt::format("{} faults", faults->lines.size()));
  return Answer{words, asText(Json{{"project", project.folder()},
                                   {"runs", faults->runs},
                                   {"files", faults->files},
                                   {"faults", faults->lines},
                                   {"unfinished", unfinished.json},
                                   {"said", project.said()}})};
}

Result<Answer> runProject(const ProjectLine& line) {
  auto project =
      Project::open(line.folder, line.action == "add" ? Project::Missing::isMade : Project::Missing::isAnError);
  if (!project) return project.error();
  if (line.action == "list") return list(*project, line);
  if (line.action == "show") return show(*project, line);
  if (line.action == "add") return add(*project, line);
  if (line.action == "note") return note(*project, line);
  if (line.action == "compare") return compare(*project, line);
  return line.action == "rebuild" ? rebuild(*project) : check(*project);
}

/// Empty where `text` is a date or its beginning, "2026" to "2026-03-02T09:14:07Z"; else what was expected.
std::string isDate(const std::string& text) {
  const std::string_view form = "0000-00-00T00:00:00Z";
  bool good = text.size() >= 4 && text.size() <= form.size();
  for (size_t k = 0; good && k < text.size(); ++k)
    good = form[k] == '0' ? text[k] >= '0' && text[k] <= '9' : text[k] == form[k];
  return good ? "" : "expected a date such as 2026-03-01, found \"" + text + "\"";
}

void addFilters(CLI::App& command, ProjectLine& line) {
  command.add_option("--motor", line.added.motor,
                     "list: only this motor's runs, by its serial number; add, note: whose run it is");
  command.add_option("--kind", line.added.kind, "list: only runs of this kind; add: of which kind it is");
  command.add_option("--device", line.filter.device, "list: only runs on this board, by its model or serial number");
  command.add_option("--since", line.filter.since, "list: only runs since this date, e.g. 2026-03-01")->check(isDate);
  command.add_option("--until", line.filter.until, "list: only runs until this date, included")->check(isDate);
  command.add_option("--text", line.filter.text, "list: only runs with this in name, remark, verdict or command");
  command.add_option("--most", line.filter.most, "list: only so many, the newest");
  command.add_flag("--history", line.history,
                   "list: each result over the dates, with its interval, and maps and findings");
}

}  // namespace

void addProject(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<ProjectLine>();
  auto* command = app.add_subcommand("project", "Keep runs in a folder: list, show, add, compare and check them");
  command->add_option("action", line->action, "list, show, add, note, compare, rebuild or check")
      ->required()
      ->check(CLI::IsMember({"list", "show", "add", "note", "compare", "rebuild", "check"}));
  command->add_option("DIR", line->folder, "the project's folder; add makes a new one")->required();
  command->add_option("RUN", line->words,
                      "show, note, compare: runs by their identifier, its beginning, their name, their date, or last; "
                      "add: files and folders to put in as one run");
  command->add_option("--name", line->added.name, "add, note: what the run is called");
  command->add_option("--remark", line->added.remark, "add, note: what there is to say of it");
  command->add_option("--out", line->out, "compare: folder for report.html, comparison.json and figures");
  addFilters(*command, *line);
  command->footer(
      "Examples:\n"
      "  breakaway project list bench3 --motor 0117 --history\n"
      "  breakaway project add bench3 c --name \"before greasing\"\n"
      "  breakaway project compare bench3 \"before greasing\" last --out cmp\n"
      "  breakaway project check bench3");
  command->callback([line, &chosen] {
    line->filter.motor = line->added.motor;
    line->filter.kind = line->added.kind;
    chosen = [line] { return runProject(*line); };
  });
}

}  // namespace breakaway::cli
