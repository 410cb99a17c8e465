// Frames on the wire: header, body and checksum, stuffed so that a zero byte ends a frame and stands nowhere else.
// Freestanding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/wire/crc32c.h"

namespace breakaway::wire {

inline constexpr std::uint8_t version = 1;
inline constexpr std::size_t mostFrame = 512;  ///< on the wire, with stuffing and the zero at the end
inline constexpr std::size_t headerSize = 4, checksumSize = 4;
inline constexpr std::size_t mostPayload = mostFrame - 1 - 3;  ///< three code bytes stuff up to 762
inline constexpr std::size_t mostBody = mostPayload - headerSize - checksumSize;

/// One frame as it was meant. The body belongs to whoever made it and lives until their next frame.
struct Frame {
  std::uint8_t type = 0;
  std::uint16_t sequence = 0;
  std::span<const std::uint8_t> body;
};

/// Writes the frame into `out` and returns how many bytes it took; 0 when the body is longer than mostBody or `out` is
/// too short (mostFrame is always enough). Stuffing: Cheshire, Baker, "Consistent overhead byte stuffing", IEEE/ACM
/// Trans. Networking 7(2), 1999.
class FrameEncoder {
 public:
  static std::size_t encode(const Frame& frame, std::span<std::uint8_t> out) {
    if (frame.body.size() > mostBody) return 0;
    FrameEncoder encoder(out);
    const std::uint8_t header[headerSize] = {version, frame.type, static_cast<std::uint8_t>(frame.sequence),
                                             static_cast<std::uint8_t>(frame.sequence >> 8)};
    for (const std::uint8_t byte : header) encoder.summed(byte);
    for (const std::uint8_t byte : frame.body) encoder.summed(byte);
    const std::uint32_t sum = encoder.crc_.value();
    for (int k = 0; k < 4; ++k) encoder.stuffed(static_cast<std::uint8_t>(sum >> (8 * k)));
    return encoder.ended();
  }

 private:
  explicit FrameEncoder(std::span<std::uint8_t> out) : out_(out) {}

  void summed(std::uint8_t byte) {
    crc_.add(byte);
    stuffed(byte);
  }
  void put(std::size_t at, std::uint8_t byte) {
    if (at < out_.size()) out_[at] = byte;
  }
  void close() {
    put(code_, run_);
    code_ = used_++;
    run_ = 1;
  }
  void stuffed(std::uint8_t byte) {
    if (run_ == 0xFF) close();
    if (byte == 0) {
      close();
      return;
    }
    put(used_++, byte);
    ++run_;
  }
  std::size_t ended() {
    put(code_, run_);
    put(used_++, 0);
    return used_ <= out_.size() ? used_ : 0;
  }

  std::span<std::uint8_t> out_;
  std::size_t used_ = 1, code_ = 0;
  std::uint8_t run_ = 1;
  Crc32c crc_;
};

/// What a decoder has seen. Bytes that belong to no good frame show up as one of the errors.
struct FrameCounts {
  std::uint32_t good = 0;
  std::uint32_t damaged = 0;   ///< the checksum or the stuffing is wrong
  std::uint32_t tooShort = 0;  ///< no room for header and checksum
  std::uint32_t tooLong = 0;
  std::uint32_t otherVersion = 0;
  std::uint32_t errors() const { return damaged + tooShort + tooLong + otherVersion; }
};

/// Takes any bytes one by one. After damage it is in step again with the next zero byte, so that damage costs the
/// frames it touches and no more.
class FrameDecoder {
 public:
  /// Whether this byte completed a good frame, which frame() then gives until the next byte.
  bool take(std::uint8_t byte) {
    if (byte == 0) return ended();
    if (left_ == 0) {
      if (zeroFollows_) keep(0);
      left_ = byte;
      zeroFollows_ = byte != 0xFF;
      begun_ = true;
    } else {
      keep(byte);
    }
    --left_;
    return false;
  }

  Frame frame() const {
    return {kept_[1], static_cast<std::uint16_t>(kept_[2] | kept_[3] << 8),
            std::span(kept_).subspan(headerSize, length_ - headerSize - checksumSize)};
  }
  const FrameCounts& counts() const { return counts_; }

 private:
  void keep(std::uint8_t byte) {
    if (used_ < kept_.size()) kept_[used_] = byte;
    if (used_ <= kept_.size()) ++used_;
  }

  bool ended() {
    const bool any = begun_, whole = left_ == 0;
    length_ = used_;
    used_ = 0;
    left_ = 0;
    begun_ = zeroFollows_ = false;
    if (!any) return false;
    std::uint32_t& count = judged(whole);
    ++count;
    return &count == &counts_.good;
  }

  std::uint32_t& judged(bool whole) {
    if (length_ > kept_.size()) return counts_.tooLong;
    if (!whole) return counts_.damaged;
    if (length_ < headerSize + checksumSize) return counts_.tooShort;
    if (!sumFits()) return counts_.damaged;
    return kept_[0] == version ? counts_.good : counts_.otherVersion;
  }

  bool sumFits() const {
    const std::size_t end = length_ - checksumSize;
    const std::uint32_t sum = crc32c(std::span(kept_).first(end));
    for (std::size_t k = 0; k < checksumSize; ++k) {
      if (kept_[end + k] != static_cast<std::uint8_t>(sum >> (8 * k))) return false;
    }
    return true;
  }

  std::array<std::uint8_t, mostPayload> kept_{};
  std::size_t used_ = 0, length_ = 0;
  std::uint8_t left_ = 0;
  bool begun_ = false, zeroFollows_ = false;
  FrameCounts counts_;
};

}  // namespace breakaway::wire
