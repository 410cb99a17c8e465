// Bytes to and from a board, whatever carries them: a serial port, TCP, a pipe to a simulated board.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// One connection. Used by one thread at a time.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  /// Hands all of it to the system. Errors: the other end is gone, or took nothing for a second.
  virtual Result<void> write(std::span<const std::uint8_t> bytes) = 0;
  /// Appends what came, waiting at most `wait_s` for the first byte (0: takes only what is there). Nothing came: no
  /// error, nothing appended. Errors: the other end is gone.
  virtual Result<void> read(std::vector<std::uint8_t>& bytes, double wait_s) = 0;
};

}  // namespace breakaway
