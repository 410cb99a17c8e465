// A project: a folder that keeps what was measured and found. Its files are the truth, the index follows them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/run.h"
#include "project/run_index.h"
#include "recording/block_file.h"

namespace breakaway {

/// A run that is to be put into a project.
struct NewRun {
  std::string kind = {};                  ///< empty: by what its files are
  std::vector<std::string> sources = {};  ///< files, and folders whose files are taken, but for names with a dot first
  std::vector<std::string> only = {};     ///< of the folders these files alone, by their names below; empty: all
  std::function<Result<void>(const std::string& folder)> write = {};  ///< writes further files of the run
  std::string name = {}, remark = {};
  std::string motor = {};  ///< empty: of the bench among the files
  std::string at = {};     ///< UTC, ISO 8601; empty: when the files were made
};

/// What a person says of a run; nothing: as it was.
struct RunNote {
  std::optional<std::string> name = {}, remark = {}, motor = {};
};

/// What is wrong in a project, one line each, and how much was looked at.
struct ProjectFaults {
  std::vector<std::string> lines;
  size_t runs = 0, files = 0;
};

/// Of a run that is a recording: its file.
inline constexpr const char* recordingFile = "recording.blocks";

/// DIR/project.json marks it, DIR/runs/DATE-KIND-ID/ holds a run: its files and run.json. Several processes may use one
/// project at once.
class Project {
 public:
  enum class Missing { isAnError, isMade };

  /// Opens the project; one that isn't there yet is made in a new or empty folder where `missing` says so. What a kill
  /// left half done is cleared away or repaired: said() tells.
  static Result<Project> open(const std::string& folder, Missing missing = Missing::isAnError);

  const std::string& folder() const { return folder_; }
  RunIndex& index() { return *index_; }
  const RunIndex& index() const { return *index_; }
  /// What was found at opening and set right, a line each.
  const std::vector<Message>& said() const { return said_; }
  /// Where a run's file lies.
  std::string pathOf(const ProjectRun& run, const std::string& file) const;

  /// Copies the run's files into the project, whole or not at all. Errors: a source can't be read, its files come from
  /// several runs, the disk is full.
  Result<ProjectRun> add(const NewRun& run);
  Result<ProjectRun> annotate(const std::string& key, const RunNote& note);
  /// Begins a run whose recording grows: its folder with run.json and the file of blocks that `blocks` opens. Wanted of
  /// `run`: name, motor, device.
  Result<ProjectRun> beginRecording(ProjectRun run, const BlockHead& head, std::optional<BlockWriter>& blocks);
  /// Says in run.json how the recording ended, with its hash. `why`: what ended it before somebody did, or empty.
  Result<ProjectRun> endRecording(const ProjectRun& run, const std::string& why);
  /// Reads every file: what is missing, changed, mixed, or isn't listed.
  Result<ProjectFaults> check() const;

 private:
  Project(std::string folder, std::unique_ptr<RunIndex> index);
  Result<void> mendRecordings();
  Result<void> repair();

  std::string folder_;
  std::unique_ptr<RunIndex> index_;
  std::vector<Message> said_;
};

}  // namespace breakaway
