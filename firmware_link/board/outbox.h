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
  /// Whether there was room, with `spare` bytes left for others.
  bool put(std::uint8_t type, std::uint16_t sequence, std::span<const std::uint8_t> body, std::size_t spare = 0) {
    std::uint8_t frame[wire::mostFrame];
    const std::size_t length = wire::FrameEncoder::encode({type, sequence, body}, frame);
    if (length == 0 || length + spare > size - waiting_) return false;
    for (std::size_t k = 0; k < length; ++k) ring_[(first_ + waiting_ + k) % size] = frame[k];
    waiting_ += length;
    return true;
  }

  /// Moves what fits into `room`; returns how many bytes that were.
  std::size_t take(std::span<std::uint8_t> room) {
    std::size_t moved = 0;
    while (moved < room.size() && waiting_ > 0) {
      room[moved++] = ring_[first_];
      first_ = (first_ + 1) % size;
      --waiting_;
    }
    return moved;
  }

  std::size_t waiting() const { return waiting_; }

 private:
  std::array<std::uint8_t, size> ring_{};
  std::size_t first_ = 0, waiting_ = 0;
};

}  // namespace breakaway::board
