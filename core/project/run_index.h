// The index of a project's runs, in SQLite: what is listed and filtered without reading every file. The files are the
// truth; the index follows them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "project/run.h"

namespace breakaway {

/// Empty texts: whatever.
struct RunFilter {
  std::string motor = {}, kind = {};
  std::string device = {};             ///< a board's model or serial number
  std::string since = {}, until = {};  ///< ISO 8601 or its beginning, both included
  std::string text = {};               ///< in name, remark, folder, verdict or command
  size_t most = 0;                     ///< the newest; 0: all
};

/// One result of one run, for histories.
struct ValueOfRun {
  std::string runId, at;
  RunValue value;
};

class RunIndex {
 public:
  /// Opens index.sqlite in the project's folder and brings it in step with runs/*/run.json. One that is missing,
  /// damaged or of another version is made anew, and `said` gets a line. Where nothing may be written, the index lives
  /// in memory. Several processes may have it open. Errors: runs/ can't be read; SQLite's.
  static Result<RunIndex> open(const std::string& folder, std::vector<Message>& said);

  RunIndex(RunIndex&&) noexcept;
  RunIndex& operator=(RunIndex&&) noexcept;
  ~RunIndex();

  /// Follows what was put there since. A run.json that can't be read is left out, and `said` gets a line.
  Result<void> follow(std::vector<Message>& said);
  /// Throws the index away and makes it from the files.
  Result<void> rebuild(std::vector<Message>& said);

  /// The newest first, without files, values and findings.
  Result<std::vector<ProjectRun>> list(const RunFilter& filter) const;
  /// The run whose identifier begins with `key`, whose folder, name or date (from the day on) it is, or the newest for
  /// "last". Errors: none, or several.
  Result<ProjectRun> find(const std::string& key) const;
  /// Whether some run has a file of this content.
  Result<bool> holds(const std::string& sha256) const;
  /// All values of the runs that pass the filter, by name, the oldest first.
  Result<std::vector<ValueOfRun>> history(const RunFilter& filter) const;
  /// The motors, by their serial number, and how many runs each has.
  Result<std::vector<std::pair<std::string, size_t>>> motors() const;

 private:
  struct State;
  explicit RunIndex(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace breakaway
