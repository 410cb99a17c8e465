// Reads a stream in a thread of its own, so that nothing is lost while the one who listens is busy.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "firmware_link/byte_stream.h"

namespace breakaway {

/// A serial driver keeps little: a tenth of a second of 10 kHz × 12 channels, then bytes are gone. This keeps
/// megabytes.
class ReadAhead final : public ByteStream {
 public:
  static constexpr size_t usualRoom = size_t{16} * 1024 * 1024;

  /// `source` bears a read and a write from two threads. Once `room` bytes wait, no more are fetched until some are
  /// taken.
  explicit ReadAhead(std::unique_ptr<ByteStream> source, size_t room = usualRoom);
  ~ReadAhead() override;
  Result<void> write(std::span<const std::uint8_t> bytes) override { return source_->write(bytes); }
  Result<void> read(std::vector<std::uint8_t>& bytes, double wait_s) override;

 private:
  void fetch(const std::stop_token& ending);

  std::unique_ptr<ByteStream> source_;
  const size_t room_;
  std::mutex lock_;
  std::condition_variable_any came_, taken_;
  std::vector<std::uint8_t> waiting_;
  std::optional<Error> gone_;
  std::jthread thread_;  // last: it starts when all else stands
};

}  // namespace breakaway
