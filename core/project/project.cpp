#include "project/project.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/made.h"
#include "base/uuid.h"
#include "project/project_lock.h"
#include "project/run_contents.h"
#include "project/stage.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {

constexpr const char* schema = "breakaway.project/1";

Result<void> readMark(const std::string& folder) {
  const OwnInputs ours;  // no input of the run
  auto root = JsonObject::fromFile(folder + "/project.json");
  if (!root) return root.error();
  if (const std::string found = root->text("schema"); found != schema)
    root->fault("schema", "is \"" + found + "\", expected \"" + schema + "\"");
  return root->finish();
}

/// Marks a new or empty folder as a project.
Result<void> makeProject(const std::string& folder) {
  std::error_code code;
  if (fs::exists(folder, code) && !fs::is_directory(folder, code))
    return Error{folder, "is a file, expected a project's folder"};
  if (fs::is_directory(folder, code) && !fs::is_empty(folder, code) && !fs::exists(folder + "/runs", code))
    return Error{folder, "is no project (it has no project.json), expected one, or a new or empty folder"};
  if (auto made = makeFolder(folder + "/runs"); !made) return made;
  return writeFile(folder + "/project.json", withMade(fmt::format("{{\"schema\": \"{}\"}}\n", schema)));
}

/// Whether there are runs in the folder: then it is a project, whatever became of its mark.
bool holdsRuns(const std::string& folder) {
  std::error_code code;
  fs::directory_iterator one(folder + "/runs", code);
  for (; !code && one != fs::directory_iterator(); one.increment(code)) {
    std::error_code ofRun;
    if (fs::exists(one->path() / "run.json", ofRun)) return true;
  }
  return false;
}

/// Of a project whose runs are there. Nothing: it is sound, or another version's, which readMark() says.
std::optional<Message> faultOfMark(const std::string& folder) {
  const OwnInputs ours;
  std::error_code code;
  if (!holdsRuns(folder)) return std::nullopt;
  if (!fs::exists(folder + "/project.json", code)) return message("was missing");
  if (!JsonObject::fromFile(folder + "/project.json")) return message("was damaged");
  return std::nullopt;
}

bool isTaken(const fs::path& name) {
  const std::string text = name.filename().string();
  return !text.starts_with(".");
}

Result<void> copyFile(const fs::path& from, const fs::path& to) {
  std::error_code code;
  fs::create_directories(to.parent_path(), code);
  if (!code) fs::copy_file(from, to, code);
  if (code) return Error{from.string(), "cannot be copied into the project: " + code.message()};
  return {};
}

/// Names of the files below a folder that are taken from it.
Result<std::vector<std::string>> filesOf(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code code;
  auto one = fs::recursive_directory_iterator(folder, code);
  for (; !code && one != fs::recursive_directory_iterator(); one.increment(code)) {
    const std::string below = one->path().lexically_relative(folder).string();
    if (!isTaken(one->path()) || below == "progress") {
      if (one->is_directory()) one.disable_recursion_pending();
    } else if (one->is_regular_file() && below != "run.json") {
      names.push_back(below);
    }
  }
  if (code) return Error{folder, "cannot be read: " + code.message()};
  return names;
}

/// Into `stage`: a file by its name, a folder's files by theirs below it.
Result<void> copySource(const std::string& source, const std::vector<std::string>& only, const fs::path& stage) {
  std::error_code code;
  if (fs::is_regular_file(source, code)) {
    if (fs::path(source).filename() == "run.json")
      return Error{source, "has the name of a project's own file, expected another one"};
    return copyFile(source, stage / fs::path(source).filename());
  }
  if (!fs::is_directory(source, code))
    return Error{source, "is " + std::string(fs::exists(source, code) ? "neither file nor folder" : "missing") +
                             ", expected a file or a folder"};
  const auto names = only.empty() ? filesOf(source) : Result(only);
  if (!names) return names.error();
  for (const std::string& name : *names) {
    if (auto copied = copyFile(fs::path(source) / name, stage / name); !copied) return copied;
  }
  return {};
}

/// Lists have a run in a line, and nothing in it may tell a terminal something.
std::string oneLine(std::string text) {
  constexpr unsigned char space = 0x20, erase = 0x7f;
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < space || static_cast<unsigned char>(c) == erase; }, ' ');
  return text;
}

/// What add() was told goes before what the files say.
void takeWords(const NewRun& told, ProjectRun& run) {
  if (!told.kind.empty()) run.kind = told.kind;
  run.motor = oneLine(told.motor.empty() ? run.motor : told.motor);
  if (!told.at.empty()) run.at = told.at;
  run.name = oneLine(told.name);
  run.remark = oneLine(told.remark);
}

}  // namespace

Project::Project(std::string folder, std::unique_ptr<RunIndex> index)
    : folder_(std::move(folder)), index_(std::move(index)) {
}

Result<Project> Project::open(const std::string& folder, Missing missing) {
  if (folder.empty()) return Error{"project", "has an empty name, expected a folder"};
  std::error_code code;
  std::vector<Message> said;
  if (const auto fault = faultOfMark(folder)) {
    if (auto made = makeProject(folder); !made) return made.error();
    said.push_back(message("{} {}: made anew", folder + "/project.json", *fault));
  } else if (!fs::exists(folder + "/project.json", code)) {
    if (missing == Missing::isAnError)
      return Error{folder, fs::exists(folder, code) ? "is no project: it has no project.json"
                                                    : "is missing, expected a project's folder"};
    if (auto made = makeProject(folder); !made) return made.error();
  }
  if (auto marked = readMark(folder); !marked) return marked.error();
  if (auto runs = makeFolder(folder + "/runs"); !runs) return runs.error();
  auto index = RunIndex::open(folder, said);
  if (!index) return index.error();
  Project project(folder, std::make_unique<RunIndex>(std::move(*index)));
  project.said_ = std::move(said);
  if (auto repaired = project.repair(); !repaired) return repaired.error();
  return project;
}

/// Clears away and mends what nobody works on any more.
Result<void> Project::repair() {
  const ProjectLock lock(folder_, ProjectLock::Way::alone);
  if (lock.held()) {
    if (const size_t left = clearStages(folder_); left > 0)
      said_.push_back(message("{}: what a kill left of {} being put in was incomplete and is removed", folder_,
                              left == 1 ? message("a run") : message("{} runs", left)));
  }
  return lock.held() ? mendRecordings() : Result<void>();
}

std::string Project::pathOf(const ProjectRun& run, const std::string& file) const {
  return folder_ + "/" + run.folder + "/" + file;
}

Result<ProjectRun> Project::add(const NewRun& told) {
  const ProjectLock lock(folder_, ProjectLock::Way::shared);
  Stage stage(folder_);
  if (auto made = stage.make(); !made) return made.error();
  for (const std::string& source : told.sources) {
    if (auto copied = copySource(source, told.only, stage.path()); !copied) return copied.error();
  }
  if (told.write) {
    if (auto written = told.write(stage.path()); !written) return written.error();
  }
  auto run = contentsOf(stage.path());
  if (!run) return Error{told.sources.empty() ? folder_ : told.sources.front(), run.error().fact};
  if (run->files.empty())
    return Error{told.sources.empty() ? folder_ : told.sources.front(), "holds no file, expected some to put in"};
  takeWords(told, *run);
  if (run->at.empty()) run->at = utcNow();
  run->id = freshUuid().substr(0, 8);
  run->folder = folderFor(*run);
  if (auto written = writeRunFile(*run, stage.path()); !written) return written.error();
  if (auto placed = stage.place(folder_ + "/" + run->folder); !placed) return placed.error();
  // The run is in, whatever the index says: that one follows at the next opening.
  static_cast<void>(index_->follow(said_));
  return run;
}

Result<ProjectRun> Project::annotate(const std::string& key, const RunNote& note) {
  const auto listed = index_->find(key);
  if (!listed) return listed.error();
  // What the index says may be older than what another process wrote.
  auto run = runOnDisk(folder_, listed->folder);
  if (!run) return run;
  run->name = oneLine(note.name.value_or(run->name));
  run->remark = oneLine(note.remark.value_or(run->remark));
  run->motor = oneLine(note.motor.value_or(run->motor));
  if (auto written = writeRunFile(*run, folder_ + "/" + run->folder); !written) return written.error();
  if (auto followed = index_->follow(said_); !followed) return followed.error();
  return run;
}

}  // namespace breakaway
