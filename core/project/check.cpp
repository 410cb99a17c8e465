// Whether a project's files are what its runs say.
#include <filesystem>
#include <set>

#include "base/sha256.h"
#include "project/project.h"
#include "project/run_contents.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {

void checkRun(const std::string& project, const ProjectRun& run, ProjectFaults& faults) {
  const std::string folder = project + "/" + run.folder;
  const auto fault = [&](const std::string& file, const std::string& fact) {
    faults.lines.push_back(Error{run.folder + "/" + file, fact}.message());
  };
  std::set<std::string> listed{"run.json"};
  for (const RunFile& one : run.files) {
    ++faults.files;
    listed.insert(one.path);
    std::error_code code;
    const std::string path = folder + "/" + one.path;
    if (!fs::is_regular_file(path, code)) {
      fault(one.path, "is missing");
      continue;
    }
    if (run.state == RunState::recording) continue;  // it grows
    const auto hash = sha256OfFile(path);
    if (!hash) {
      fault(one.path, hash.error().fact);
    } else if (*hash != one.sha256) {
      fault(one.path,
            "has changed: its SHA-256 is " + hash->substr(0, 12) + "…, expected " + one.sha256.substr(0, 12) + "…");
    }
  }
  std::error_code code;
  for (const auto& one : fs::recursive_directory_iterator(folder, code)) {
    const std::string name = one.path().lexically_relative(folder).string();
    if (one.is_regular_file(code) && !listed.contains(name) && run.state != RunState::recording)
      fault(name, "isn't listed in run.json");
  }
  if (const auto contents = contentsOf(folder); !contents)
    faults.lines.push_back(Error{run.folder, contents.error().fact}.message());
}

}  // namespace

Result<ProjectFaults> Project::check() const {
  ProjectFaults faults;
  const auto runs = index_->list({});
  if (!runs) return runs.error();
  std::set<std::string> known;
  for (const ProjectRun& one : *runs) {
    ++faults.runs;
    known.insert(one.folder);
    const auto run = index_->find(one.folder);
    if (!run) return run.error();
    checkRun(folder_, *run, faults);
    if (run->state == RunState::cut)
      faults.lines.push_back(
          Error{run->folder, "ended early" + (run->verdict.empty() ? "" : ": " + run->verdict)}.message());
  }
  std::error_code code;
  for (const auto& one : fs::directory_iterator(folder_ + "/runs", code)) {
    const std::string name = "runs/" + one.path().filename().string();
    if (known.contains(name)) continue;
    faults.lines.push_back(
        Error{name, fs::exists(one.path() / "run.json", code)
                        ? "has a run.json that can't be read: breakaway project add takes what else is in it"
                        : "has no run.json: breakaway project add takes what is in it"}
            .message());
  }
  return faults;
}

}  // namespace breakaway
