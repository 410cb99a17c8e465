// Keeps every sample it is given, up to its capacity, until it is sealed into a recording; it never decimates.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "recording/sample.h"

namespace breakaway {

class Recorder {
 public:
  /// Ten minutes at 5 kHz; further samples are not kept.
  static constexpr size_t capacity = 3'000'000;

  bool recording() const { return recording_; }
  size_t size() const { return samples_.size(); }
  void start();
  void append(std::span<const Sample> samples);
  /// Ends recording and hands over what was kept.
  std::vector<Sample> finish();

 private:
  bool recording_ = false;
  std::vector<Sample> samples_;
};

}  // namespace breakaway
