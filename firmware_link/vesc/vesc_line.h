// One VESC at the end of a stream: payloads to it and its answers.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "firmware_link/byte_stream.h"
#include "firmware_link/vesc/vesc_frame.h"
#include "firmware_link/vesc/vesc_messages.h"

namespace breakaway {

/// The first failure of the stream stays; whatever is said after it goes nowhere.
class VescLine {
 public:
  using Clock = std::chrono::steady_clock;

  explicit VescLine(std::unique_ptr<ByteStream> stream) : stream_(std::move(stream)) {}

  void say(const VescPayload& payload);
  /// The next answer, waiting at most until `end`.
  std::optional<VescPayload> hear(Clock::time_point end);
  /// An answer behind something that only looked like the start of one; for when it is overdue.
  std::optional<VescPayload> rescue() { return decoder_.rescue(); }
  const std::optional<Error>& broken() const { return broken_; }
  std::unique_ptr<ByteStream> release() { return std::move(stream_); }

 private:
  std::unique_ptr<ByteStream> stream_;
  VescDecoder decoder_;
  std::vector<std::uint8_t> fresh_;
  std::optional<Error> broken_;
};

}  // namespace breakaway
