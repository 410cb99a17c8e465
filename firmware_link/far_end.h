// The far end of a line, where a simulated board sits: a pseudo terminal, or a TCP port of this machine.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// One host at a time; the next one is let in when the last has gone. Used by one thread.
class FarEnd {
 public:
  /// A pseudo terminal, which a host opens like any serial port.
  static Result<FarEnd> pseudoTerminal();
  /// A port on the loopback; 0: any that is free.
  static Result<FarEnd> loopback(std::uint16_t port);
  FarEnd(FarEnd&& other) noexcept;
  FarEnd& operator=(FarEnd&&) = delete;
  ~FarEnd();

  /// As `--board` takes it: `serial:/dev/pts/3`, `tcp:127.0.0.1:7000`.
  const std::string& uri() const { return uri_; }
  /// Waits at most `wait_s` for bytes, or for a host, or for a signal; appends what came.
  void read(std::vector<std::uint8_t>& bytes, double wait_s);
  /// Returns how many bytes the system took, waiting at most `wait_s` for it to take any. Without a host they are gone.
  std::size_t write(std::span<const std::uint8_t> bytes, double wait_s);

 private:
  FarEnd(int listening, int line, int kept, std::string uri)
      : listening_(listening), line_(line), kept_(kept), uri_(std::move(uri)) {}
  void hangUp();

  int listening_, line_, kept_;  ///< kept: the near side of a pseudo terminal, so that it outlives its hosts
  std::string uri_;
};

}  // namespace breakaway
