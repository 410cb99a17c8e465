#include "session/live_history.h"

namespace breakaway {

void LiveHistory::append(std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    if (chunks_.empty() || chunks_.back()->size() == chunkSize) {
      chunks_.push_back(std::make_shared<Chunk>());
      chunks_.back()->reserve(chunkSize);
    }
    chunks_.back()->push_back(sample);
    ++end_;
  }
  if (first_ == end_) return;
  const double oldest_s = at(end_ - 1).time_s - span_s;
  while (at(first_).time_s < oldest_s) ++first_;
  for (; first_ - base_ >= chunkSize; base_ += chunkSize) chunks_.pop_front();
}

void LiveHistory::clear() {
  base_ = first_ = end_;
  chunks_.clear();
}

std::optional<Sample> LiveHistory::newest() const {
  if (first_ == end_) return {};
  return at(end_ - 1);
}

uint64_t LiveHistory::from(double time_s) const {
  uint64_t low = first_, high = end_;
  while (low < high) {
    const uint64_t middle = low + (high - low) / 2;
    if (at(middle).time_s < time_s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

std::vector<Sample> LiveHistory::between(double from_s, double to_s) const {
  std::vector<Sample> found;
  for (uint64_t number = from(from_s); number < end_ && at(number).time_s <= to_s; ++number)
    found.push_back(at(number));
  return found;
}

std::optional<Sample> LiveHistory::nearest(double time_s) const {
  if (first_ == end_) return {};
  const uint64_t after = from(time_s);
  if (after == first_) return at(first_);
  if (after == end_) return at(end_ - 1);
  return time_s - at(after - 1).time_s < at(after).time_s - time_s ? at(after - 1) : at(after);
}

}  // namespace breakaway
