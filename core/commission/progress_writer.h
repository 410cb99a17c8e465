// Writes what a job has measured beside the job: a disk that takes its time keeps no heartbeat from the board.
#pragma once

#include <future>
#include <optional>
#include <string>

#include "base/result.h"
#include "commission/known.h"

namespace breakaway {

/// Into `folder`, as writeProgress() does. From one thread.
class ProgressWriter {
 public:
  explicit ProgressWriter(std::string folder);
  ~ProgressWriter();
  ProgressWriter(const ProgressWriter&) = delete;
  ProgressWriter& operator=(const ProgressWriter&) = delete;

  /// Begins to write it, or remembers it for later while something is being written. Errors: of what was written
  /// before.
  Result<void> keep(const Commission& known);
  /// Waits until all of it is written.
  Result<void> finish();
  /// Whether there was anything.
  bool wrote() const { return wrote_; }

 private:
  std::string folder_;
  std::future<Result<void>> writing_;
  std::optional<Commission> later_;
  bool wrote_ = false;
};

}  // namespace breakaway
