// Bytes through a file descriptor of the system: a serial line or a socket, without an event loop.
#pragma once

#include <string>
#include <utility>

#include "firmware_link/byte_stream.h"

namespace breakaway {

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }

 private:
  int number_;
};

/// One thread may read while another writes; the two share nothing.
class DescriptorStream final : public ByteStream {
 public:
  /// `descriptor` doesn't block; `name` stands in the errors.
  DescriptorStream(Descriptor descriptor, std::string name);
  Result<void> write(std::span<const std::uint8_t> bytes) override;
  Result<void> read(std::vector<std::uint8_t>& bytes, double wait_s) override;

 private:
  Error gone(int reason) const;
  Descriptor descriptor_;
  std::string name_;
  bool socket_ = false;
};

}  // namespace breakaway
