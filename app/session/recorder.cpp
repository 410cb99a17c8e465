#include "session/recorder.h"

#include <algorithm>
#include <utility>

namespace breakaway {

void Recorder::start() {
  samples_.clear();
  recording_ = true;
}

void Recorder::append(std::span<const Sample> samples) {
  if (!recording_) return;
  const size_t room = capacity - std::min(capacity, samples_.size());
  const auto taken = samples.first(std::min(room, samples.size()));
  samples_.insert(samples_.end(), taken.begin(), taken.end());
}

std::vector<Sample> Recorder::finish() {
  recording_ = false;
  return std::exchange(samples_, {});
}

}  // namespace breakaway
