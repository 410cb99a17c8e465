// A pseudo terminal: a serial port whose far end a test holds in its hands.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

namespace breakaway::test {

class Pty {
 public:
  Pty() : far_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    std::array<char, 128> name{};
    if (::grantpt(far_) == 0 && ::unlockpt(far_) == 0) ::ptsname_r(far_, name.data(), name.size());
    path_ = name.data();
  }
  ~Pty() { hangUp(); }
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  /// What a program opens.
  const std::string& path() const { return path_; }
  int far() const { return far_; }
  /// The cable is pulled.
  void hangUp() {
    if (far_ >= 0) ::close(far_);
    far_ = -1;
  }
  /// Blocks until all is taken; false when the other end is gone.
  bool send(std::span<const std::uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t taken = ::write(far_, bytes.data(), bytes.size());
      if (taken <= 0) return false;
      bytes = bytes.subspan(static_cast<size_t>(taken));
    }
    return true;
  }
  /// What there is, at least one byte; empty when the other end is gone.
  std::vector<std::uint8_t> receive() const {
    std::vector<std::uint8_t> bytes(4096);
    const ssize_t got = ::read(far_, bytes.data(), bytes.size());
    bytes.resize(got > 0 ? static_cast<size_t>(got) : 0);
    return bytes;
  }

 private:
  int far_;
  std::string path_;
};

}  // namespace breakaway::test
