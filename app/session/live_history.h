// The last minute of samples at the full rate: what the live plots show and what their visible range exports.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "recording/sample.h"

namespace breakaway {

class LiveHistory {
 public:
  static constexpr double span_s = 60.0;

  void append(std::span<const Sample> samples);
  void clear();

  /// Samples are numbered from the first one ever appended; those in [first(), end()) are still kept.
  uint64_t first() const { return first_; }
  uint64_t end() const { return first_ + samples_.size(); }
  const Sample& at(uint64_t number) const { return samples_[number - first_]; }
  std::optional<Sample> newest() const;

  /// The samples with from ≤ time ≤ to, at the full rate.
  std::vector<Sample> between(double from_s, double to_s) const;
  /// The sample nearest to a time; nothing when none is kept.
  std::optional<Sample> nearest(double time_s) const;

 private:
  std::deque<Sample> samples_;
  uint64_t first_ = 0;
};

}  // namespace breakaway
