// Frames that wait to be sent. Freestanding, no heap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/wire/frame.h"

namespace breakaway::board {

/// A ring of bytes. A frame goes in whole or not at all.
template <std::size_t size>
class Outbox {
 public:
  bool put(std::uint8_t type, std::uint16_t sequence, std::span<const std::uint8_t> body) {
    std::uint8_t frame[wire::mostFrame];
    const std::size_t length = wire::FrameEncoder::encode({type, sequence, body}, frame);
    return length > 0 && put(std::span(frame).first(length));
  }

  /// Whether there was room for the frame, with `spare` bytes left for others.
  bool put(std::span<const std::uint8_t> frame, std::size_t spare = 0) {
    if (frame.size() + spare > size - waiting_) return false;
    std::size_t at = first_ + waiting_;
    if (at >= size) at -= size;
    const std::size_t toEnd = size - at, straight = frame.size() < toEnd ? frame.size() : toEnd;
    copy(ring_.data() + at, frame.data(), straight);
    copy(ring_.data(), frame.data() + straight, frame.size() - straight);
    waiting_ += frame.size();
    return true;
  }

  /// Moves what fits into `room`; returns how many bytes that were.
  std::size_t take(std::span<std::uint8_t> room) {
    const std::size_t moved = room.size() < waiting_ ? room.size() : waiting_;
    const std::size_t toEnd = size - first_, straight = moved < toEnd ? moved : toEnd;
    copy(room.data(), ring_.data() + first_, straight);
    copy(room.data() + straight, ring_.data(), moved - straight);
    first_ = straight < toEnd ? first_ + straight : moved - straight;
    waiting_ -= moved;
    return moved;
  }

  std::size_t waiting() const { return waiting_; }

 private:
  /// By words: a small library's memcpy goes byte by byte.
  static void copy(std::uint8_t* to, const std::uint8_t* from, std::size_t count) {
    for (; count >= 4; count -= 4, to += 4, from += 4) __builtin_memcpy(to, from, 4);
    for (; count > 0; --count) *to++ = *from++;
  }

  std::array<std::uint8_t, size> ring_{};
  std::size_t first_ = 0, waiting_ = 0;
};

}  // namespace breakaway::board
