// One run in a project, as its run.json tells it: what was done, when, on which motor, and which files it left.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace breakaway {

struct RunFile {
  std::string path;  ///< below the run's folder
  std::string kind;  ///< its schema's name ("map", "diagnosis", …), "recording", "report", "figure" or "file"
  std::uint64_t bytes = 0;
  std::string sha256;  ///< empty while the file grows
  bool operator==(const RunFile&) const = default;
};

/// A result with its 95 % interval, named with its SI unit.
struct RunValue {
  std::string name;
  double value = 0.0, low = 0.0, high = 0.0;
  bool operator==(const RunValue&) const = default;
};

/// How far a run came.
enum class RunState {
  whole,
  recording,  ///< its recording grows
  cut         ///< it ended early: a kill, a lost link, a full disk
};

struct ProjectRun {
  std::string id;      ///< eight hexadecimal digits
  std::string folder;  ///< below the project: runs/DATE-KIND-ID
  std::string kind;    ///< commission, identification, diagnosis, tuning, recording, …
  RunState state = RunState::whole;
  std::string name, remark;  ///< a person's
  std::string motor;         ///< which one: the bench's motor_serial
  std::string device, deviceSerial, firmware;
  std::string at;  ///< when it began: UTC, ISO 8601
  std::string by, command;
  std::string verdict;                ///< of a diagnosis
  std::vector<std::string> findings;  ///< of a diagnosis, in words
  std::vector<RunValue> values;
  std::vector<RunFile> files;
  bool operator==(const ProjectRun&) const = default;

  /// The first file of this kind; nullptr: none.
  const RunFile* file(std::string_view fileKind) const;
  /// The value of this name; nullptr: none.
  const RunValue* value(std::string_view valueName) const;
};

/// "whole", "recording" or "cut".
const char* wordOf(RunState state);

/// Whether this is a time as runs have it: UTC, ISO 8601 to the second or finer, "2026-03-02T09:14:07Z".
bool isRunTime(std::string_view at);

/// "runs/2026-03-02T091407Z-commission-8b504e58": sorts by time, and is a file's name anywhere.
std::string folderFor(const ProjectRun& run);

/// The run as `breakaway.run/1`, without its folder.
std::string runText(const ProjectRun& run);

/// Writes run.json into the run's folder.
Result<void> writeRunFile(const ProjectRun& run, const std::string& folder);

/// What run.json in `folder`, below `project`, says now. Errors: readRunText()'s, or there is none.
Result<ProjectRun> runOnDisk(const std::string& project, const std::string& folder);

/// What runText() gave. Errors, at `place`: a field is missing or wrong.
Result<ProjectRun> readRunText(const std::string& text, const std::string& place);

}  // namespace breakaway
