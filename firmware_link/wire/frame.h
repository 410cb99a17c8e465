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

/// Makes a frame, as a whole or piece by piece. Stuffing: Cheshire, Baker, "Consistent overhead byte stuffing",
/// IEEE/ACM Trans. Networking 7(2), 1999.
class FrameEncoder {
 public:
  /// Writes the frame into `out` and returns how many bytes it took; 0 when the body is longer than mostBody or `out`
  /// is too short (mostFrame is always enough).
  static std::size_t encode(const Frame& frame, std::span<std::uint8_t> out) {
    if (frame.body.size() > mostBody) return 0;
    std::array<std::uint8_t, mostFrame> room;
    FrameEncoder encoder(out.size() < mostFrame ? room.data() : out.data(), frame.type, frame.sequence);
    encoder.add(frame.body);
    const std::size_t size = encoder.end();
    if (out.size() >= mostFrame) return size;
    if (size > out.size()) return 0;
    for (std::size_t k = 0; k < size; ++k) out[k] = room[k];
    return size;
  }

  FrameEncoder() = default;
  /// Begins a frame in `room`, which holds mostFrame bytes and outlives it.
  FrameEncoder(std::uint8_t* room, std::uint8_t type, std::uint16_t sequence) : room_(room) {
    const std::uint8_t header[headerSize] = {version, type, static_cast<std::uint8_t>(sequence),
                                             static_cast<std::uint8_t>(sequence >> 8)};
    add(header);
  }
  /// Further bytes of the body, mostBody altogether.
  void add(std::span<const std::uint8_t> bytes) {
    crc_.add(bytes);
    stuff(bytes);
  }
  /// Ends the frame and returns how many bytes it took.
  std::size_t end() {
    const std::uint32_t sum = crc_.value();
    std::uint8_t bytes[checksumSize];
    for (std::size_t k = 0; k < checksumSize; ++k) bytes[k] = static_cast<std::uint8_t>(sum >> (8 * k));
    stuff(bytes);
    room_[used_ - run_] = run_;
    room_[used_] = 0;
    return used_ + 1;
  }

 private:
  void stuff(std::span<const std::uint8_t> bytes) {
    std::uint8_t* to = room_ + used_;
    std::uint8_t run = run_;
    for (const std::uint8_t byte : bytes) {
      if (run == 0xFF) {
        *(to - run) = run;
        ++to;
        run = 1;
      }
      if (byte == 0) {
        *(to - run) = run;
        run = 0;
      } else {
        *to = byte;
      }
      ++to;
      ++run;
    }
    used_ = static_cast<std::size_t>(to - room_);
    run_ = run;
  }

  std::uint8_t* room_ = nullptr;
  std::size_t used_ = 1;
  std::uint8_t run_ = 1;  ///< bytes since the last code, which stands so far back, with it
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
