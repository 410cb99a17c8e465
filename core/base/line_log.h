// A log of lines that long runs append to: a kill loses at most the line that was being written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// The whole lines of the file at `path`, without their ends; none when there is no such file, or a device. A last line
/// that doesn't end was cut short by a kill and is left out. Errors: the file can't be read.
Result<std::vector<std::string>> readWholeLines(const std::string& path);

/// The one writer of a log of lines: while this lives, no other process may have the same.
class OwnLineLog {
 public:
  /// Opens the file, creating it; a device and standard output ("-") have no lines, and any number of writers. Errors:
  /// it can't be written; another process has it.
  static Result<OwnLineLog> open(const std::string& path);

  OwnLineLog(OwnLineLog&& other) noexcept;
  OwnLineLog& operator=(OwnLineLog&&) = delete;
  ~OwnLineLog();

  /// What readWholeLines() reads.
  Result<std::vector<std::string>> lines() const { return readWholeLines(path_); }
  /// As appendLine().
  Result<void> append(std::string_view line) const;
  /// Puts `lines` in place of all that is there, in one step. Error: nothing has changed, or another process has it.
  Result<void> replace(const std::vector<std::string>& lines);

 private:
  explicit OwnLineLog(std::string path) : path_(std::move(path)) {}
  Result<void> take();

  std::string path_;
  int file_ = -1;  ///< −1: a device, or standard output
};

/// Appends `line` and its end in one go, creating the file and cutting away a last line that was cut short. Several
/// processes may append to the same file. Precondition: `line` holds no line end.
Result<void> appendLine(const std::string& path, std::string_view line);

}  // namespace breakaway
