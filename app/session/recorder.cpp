#include "session/recorder.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "recording/sample_recording.h"

namespace breakaway {

using namespace std::chrono_literals;

namespace {
constexpr auto writeEvery = 200ms;
constexpr auto syncEvery = 1s;
}  // namespace

Recorder::Recorder(BlockWriter writer, Listener listener, const RecorderOptions& options)
    : writer_(std::move(writer)), listener_(std::move(listener)), options_(options) {
  end_.path = writer_.path();
  thread_ = std::thread([this] { work(); });
}

Recorder::~Recorder() {
  finish();
  wait();
}

void Recorder::wait() {
  if (thread_.joinable()) thread_.join();
}

void Recorder::append(std::span<const Sample> samples, size_t lost) {
  const std::lock_guard lock(lock_);
  if (closed_) return;
  if (lost > 0) waiting_.lost.emplace_back(waiting_.samples.size(), lost);
  waiting_.samples.insert(waiting_.samples.end(), samples.begin(), samples.end());
  taken_ += samples.size();
  if (waiting_.samples.size() <= options_.mostWaiting) return;
  closed_ = waiting_.finished = true;
  waiting_.why = message("the disk was too slow");
  wake_.notify_one();
}

void Recorder::finish(const std::string& why) {
  const std::lock_guard lock(lock_);
  if (closed_) return;
  closed_ = waiting_.finished = true;
  waiting_.why = why;
  wake_.notify_one();
}

void Recorder::work() {
  auto synced = std::chrono::steady_clock::now();
  Result<void> done;
  for (bool last = false; !last;) {
    Waiting part;
    {
      std::unique_lock lock(lock_);
      wake_.wait_for(lock, writeEvery, [this] { return waiting_.finished; });
      std::swap(part, waiting_);
    }
    last = part.finished;
    done = write(part);
    if (done && std::chrono::steady_clock::now() - synced >= syncEvery) {
      done = watchDisk();
      if (done) done = writer_.sync();
      synced = std::chrono::steady_clock::now();
    }
    end_.why = part.why;
    if (done) continue;
    const std::lock_guard lock(lock_);
    closed_ = last = true;
    end_.why = done.error().fact;
  }
  if (const auto ended = writer_.end(end_.why); !ended && end_.why.empty()) end_.why = ended.error().fact;
  end_.duration_s = last_s_ - first_s_;
  if (listener_.ended) listener_.ended(end_);
}

Result<void> Recorder::write(const Waiting& part) {
  size_t from = 0;
  const auto writeTo = [&](size_t to) -> Result<void> {
    rows_.clear();
    for (size_t k = from; k < to; ++k) appendRow(part.samples[k], rows_);
    from = to;
    return writer_.append(rows_);
  };
  for (const auto& [before, count] : part.lost) {
    if (auto written = writeTo(before); !written) return written;
    const double after_s = before > 0 ? part.samples[before - 1].time_s : last_s_;
    if (auto written = writer_.appendGap({after_s, count}); !written) return written;
    end_.lost += count;
  }
  if (auto written = writeTo(part.samples.size()); !written) return written;
  if (part.samples.empty()) return {};
  if (end_.rows == 0) first_s_ = part.samples.front().time_s;
  last_s_ = part.samples.back().time_s;
  end_.rows += part.samples.size();
  return {};
}

/// The end is said before it comes, and comes in order while there is room for it.
Result<void> Recorder::watchDisk() {
  std::error_code code;
  const auto free = std::filesystem::space(std::filesystem::path(writer_.path()).parent_path(), code).available;
  if (code) return {};
  if (free < options_.reserve_bytes) return Error{writer_.path(), message("the disk is full")};
  const double recorded_s = last_s_ - first_s_;
  if (warned_ || recorded_s <= 0.0 || !listener_.warned) return {};
  const double left_s =
      static_cast<double>(free - options_.reserve_bytes) * recorded_s / static_cast<double>(writer_.bytes());
  if (left_s > options_.warnBefore_s) return {};
  warned_ = true;
  listener_.warned(message("the disk has room for about {} s more; then the recording ends", static_cast<int>(left_s)));
  return {};
}

}  // namespace breakaway
