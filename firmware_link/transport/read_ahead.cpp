#include "firmware_link/transport/read_ahead.h"

#include <chrono>
#include <utility>

namespace breakaway {

namespace {
constexpr double turn_s = 0.02;  // so long at most a closing stream waits for its thread
// A port that hands over byte by byte would wake its reader for each; so much later they come in dozens.
constexpr std::chrono::microseconds gathered{200};
}  // namespace

ReadAhead::ReadAhead(std::unique_ptr<ByteStream> source, size_t room)
    : source_(std::move(source)), room_(room), thread_([this](const std::stop_token& ending) { fetch(ending); }) {
}

ReadAhead::~ReadAhead() {
  thread_.request_stop();
  thread_.join();
}

void ReadAhead::fetch(const std::stop_token& ending) {
  std::vector<std::uint8_t> fresh;
  while (!ending.stop_requested()) {
    fresh.clear();
    const auto read = source_->read(fresh, turn_s);
    std::unique_lock lock(lock_);
    waiting_.insert(waiting_.end(), fresh.begin(), fresh.end());
    if (!read) gone_ = read.error();
    if (!fresh.empty() || gone_) came_.notify_one();
    if (gone_) return;
    taken_.wait(lock, ending, [this] { return waiting_.size() < room_; });
    lock.unlock();
    if (!fresh.empty()) std::this_thread::sleep_for(gathered);
  }
}

Result<void> ReadAhead::read(std::vector<std::uint8_t>& bytes, double wait_s) {
  std::unique_lock lock(lock_);
  const auto anything = [this] { return !waiting_.empty() || gone_; };
  if (wait_s > 0.0) came_.wait_for(lock, std::chrono::duration<double>(wait_s), anything);
  if (waiting_.empty()) return gone_ ? Result<void>(*gone_) : Result<void>{};
  if (bytes.empty()) {
    bytes.swap(waiting_);
  } else {
    bytes.insert(bytes.end(), waiting_.begin(), waiting_.end());
  }
  waiting_.clear();
  taken_.notify_one();
  return {};
}

}  // namespace breakaway
