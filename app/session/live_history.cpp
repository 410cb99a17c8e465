#include "session/live_history.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {
bool earlier(const Sample& sample, double time_s) {
  return sample.time_s < time_s;
}
}  // namespace

void LiveHistory::append(std::span<const Sample> samples) {
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  if (samples_.empty()) return;
  const auto keep = std::lower_bound(samples_.begin(), samples_.end(), samples_.back().time_s - span_s, earlier);
  first_ += static_cast<uint64_t>(keep - samples_.begin());
  samples_.erase(samples_.begin(), keep);
}

void LiveHistory::clear() {
  first_ = end();
  samples_.clear();
}

std::optional<Sample> LiveHistory::newest() const {
  if (samples_.empty()) return {};
  return samples_.back();
}

std::vector<Sample> LiveHistory::between(double from_s, double to_s) const {
  const auto from = std::lower_bound(samples_.begin(), samples_.end(), from_s, earlier);
  auto to = std::lower_bound(from, samples_.end(), to_s, earlier);
  if (to != samples_.end() && to->time_s <= to_s) ++to;
  return {from, to};
}

std::optional<Sample> LiveHistory::nearest(double time_s) const {
  if (samples_.empty()) return {};
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), time_s, earlier);
  if (after == samples_.begin()) return samples_.front();
  if (after == samples_.end()) return samples_.back();
  const auto before = std::prev(after);
  return time_s - before->time_s < after->time_s - time_s ? *before : *after;
}

}  // namespace breakaway
