// The last minute of samples at the full rate: what the live plots show and what their visible range exports. A copy
// costs nearly nothing, and keeps what it holds while the original goes on: what is looked at while a plot stands
// still.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "recording/sample.h"

namespace breakaway {

class LiveHistory {
 public:
  static constexpr double span_s = 60.0;

  /// To the original only, in the thread that reads the copies.
  void append(std::span<const Sample> samples);
  void clear();

  /// Samples are numbered from the first one ever appended; those in [first(), end()) are still kept.
  uint64_t first() const { return first_; }
  uint64_t end() const { return end_; }
  const Sample& at(uint64_t number) const {
    return (*chunks_[(number - base_) / chunkSize])[(number - base_) % chunkSize];
  }
  std::optional<Sample> newest() const;

  /// The samples with from ≤ time ≤ to, at the full rate.
  std::vector<Sample> between(double from_s, double to_s) const;
  /// The sample nearest to a time; nothing when none is kept.
  std::optional<Sample> nearest(double time_s) const;

 private:
  static constexpr size_t chunkSize = 4096;
  using Chunk = std::vector<Sample>;  ///< never grows beyond what it was made for, so that nothing in it moves

  /// The first one that isn't earlier.
  uint64_t from(double time_s) const;

  std::deque<std::shared_ptr<Chunk>> chunks_;  ///< all but the last are full
  uint64_t base_ = 0;                          ///< number of the first sample of the first chunk
  uint64_t first_ = 0, end_ = 0;
};

}  // namespace breakaway
