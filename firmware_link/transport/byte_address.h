// Where a board's bytes come from, read from its URI: `serial:PORT[@BAUD]` or `tcp:HOST:PORT`.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"

namespace breakaway {

struct ByteAddress {
  enum class Kind { serial, tcp };
  static constexpr unsigned usualBaud = 115200;

  Kind kind = Kind::serial;
  std::string device;         ///< of a serial port, with its folder
  unsigned baud = usualBaud;  ///< bits per second; ports on USB ignore it
  std::string host;           ///< this machine's loopback where the URI names none
  std::uint16_t port = 0;
  bool operator==(const ByteAddress&) const = default;

  /// As the system calls it, for errors: "serial port /dev/ttyACM0", "127.0.0.1:2000".
  std::string words() const;
};

/// `serial:ttyACM0`, `serial:/dev/ttyUSB0@921600`, `tcp:bench3:2000`, `tcp:[::1]:2000`, `tcp::2000`, `tcp:2000`. An
/// error says which part is wrong and what was expected.
Result<ByteAddress> byteAddressOf(const std::string& uri);

/// Does `uri` name a serial port or a TCP address, right or wrong?
bool carriesBytes(const std::string& uri);

}  // namespace breakaway
