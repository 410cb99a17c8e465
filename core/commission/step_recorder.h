// Runs one procedure on a drive to its end and keeps a recording of it.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "experiment/drive.h"
#include "recording/recording.h"

namespace breakaway {

/// Appends samples as columns of a recording, every n-th one; says so in the recording's notes.
class StepRecorder {
 public:
  StepRecorder(std::string step, size_t every, Axis axis = Axis::rotary)
      : step_(std::move(step)), every_(every), axis_(axis) {}

  void append(const std::vector<Sample>& samples);
  bool empty() const { return kept_.empty(); }
  /// The recording's columns (columns.h). `index` is set in the kept row after which it was seen.
  Result<Recording> seal(const std::vector<std::pair<std::string, std::string>>& notes) const;

 private:
  std::string step_;
  size_t every_, seen_ = 0;
  Axis axis_;
  bool index_ = false;
  std::vector<Sample> kept_;
};

}  // namespace breakaway
