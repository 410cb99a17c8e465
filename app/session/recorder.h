// Puts every sample that it is given on the disk, in a thread of its own: whoever gives them never waits.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/message.h"
#include "recording/block_file.h"
#include "recording/sample.h"

namespace breakaway {

struct RecorderOptions {
  std::uint64_t reserve_bytes = std::uint64_t{64} << 20U;  ///< of the disk that are left free: recording ends before
  double warnBefore_s = 300.0;                             ///< of recording that the disk has room for
  size_t mostWaiting = 3'000'000;  ///< samples that a slow disk may hold up; beyond, recording ends
};

/// What became of a recording.
struct RecordingEnd {
  std::string path;
  std::uint64_t rows = 0, lost = 0;
  double duration_s = 0.0;
  std::string why;  ///< what ended it before somebody did; empty otherwise
};

class Recorder {
 public:
  /// Either is called in the recorder's thread: `ended` once, at the end; `warned` when the disk will soon be full.
  struct Listener {
    std::function<void(const RecordingEnd&)> ended;
    std::function<void(const Message&)> warned;
  };

  Recorder(BlockWriter writer, Listener listener, const RecorderOptions& options = {});
  /// Writes what was given, then ends.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Takes samples, and how many were lost before them. Waits for nothing but another call.
  void append(std::span<const Sample> samples, size_t lost);
  /// No more will come; `why` as in RecordingEnd. The first call counts.
  void finish(const std::string& why = {});
  /// Waits until all is written. Precondition: finish() was called.
  void wait();
  /// What became of it, after wait().
  const RecordingEnd& end() const { return end_; }
  /// Samples taken so far.
  std::uint64_t taken() const { return taken_.load(); }

 private:
  struct Waiting {
    std::vector<Sample> samples;
    std::vector<std::pair<size_t, size_t>> lost;  ///< before the sample of this number so many
    bool finished = false;
    std::string why;
  };

  void work();
  Result<void> write(const Waiting& part);
  Result<void> watchDisk();

  BlockWriter writer_;
  const Listener listener_;
  const RecorderOptions options_;
  std::atomic<std::uint64_t> taken_{0};
  std::mutex lock_;
  std::condition_variable wake_;
  Waiting waiting_;
  bool closed_ = false;  ///< nothing is taken any more

  // The thread's own.
  RecordingEnd end_;
  double first_s_ = 0.0, last_s_ = 0.0;
  std::vector<double> rows_;
  bool warned_ = false;

  std::thread thread_;  // last: it starts when all else stands
};

}  // namespace breakaway
