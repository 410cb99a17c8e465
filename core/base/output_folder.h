// The folder that a command fills: its files come from one run, put in place when all of them are whole.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace breakaway {

struct OutputPlan {
  std::string folder;
  std::string command;              ///< whose files these are: another command's are never replaced
  std::vector<std::string> names;   ///< of files and folders that are written into it; the last is put in place last
  std::vector<std::string> inputs;  ///< files that must not be replaced
};

/// Holds the folder from the work's begin to its end. Files are written into a folder beside it (within it, where it is
/// a mount point or nothing may be written beside it). When all are whole, it becomes the output folder in one step;
/// where that one holds other files besides those of an earlier run, or is where the process runs, file by file, those
/// of the earlier run being removed. Other files stay.
class OutputFolder {
 public:
  /// Errors, before anything is changed: an empty name, a file in the folder's place, nothing may be written there,
  /// another process writes into it, a file that would be replaced is an input or another command's.
  static Result<OutputFolder> open(OutputPlan plan);

  OutputFolder(OutputFolder&&) noexcept;
  OutputFolder& operator=(OutputFolder&&) noexcept;
  ~OutputFolder();

  /// A line, when an earlier run's files were there and are replaced; else nothing.
  std::string inWords() const;
  /// The names of the run's files below the folder, once it is filled.
  std::vector<std::string> files() const;
  /// Calls `write` with the folder to write into, and puts that in place. `left`: names in the output folder that the
  /// run itself has put there and that go then. An error names files as if they were in place; nothing has changed
  /// then.
  Result<void> fill(const std::function<Result<void>(const std::string& folder)>& write,
                    const std::vector<std::string>& left = {});

 private:
  struct State;
  explicit OutputFolder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace breakaway
