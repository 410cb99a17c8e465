// VESC's frames: `02 length payload crc 03`, above 255 bytes `03 lengthHi lengthLo payload crc 03`; the checksum is
// CRC-16/XMODEM of the payload, high byte first.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace breakaway {

constexpr size_t mostVescPayload = 512;  // what a VESC's own buffer holds

/// CRC-16/XMODEM: polynomial x¹⁶+x¹²+x⁵+1 (0x1021), from zero, nothing reflected.
std::uint16_t crc16Xmodem(std::span<const std::uint8_t> bytes);

/// `payload` has 1 to mostVescPayload bytes.
std::vector<std::uint8_t> vescFrame(std::span<const std::uint8_t> payload);

/// Finds frames in any bytes. What belongs to none is dropped and counted; after a damaged frame the search goes on
/// right behind its first byte, so that a good one inside or behind it is found.
class VescDecoder {
 public:
  void add(std::span<const std::uint8_t> bytes) { waiting_.insert(waiting_.end(), bytes.begin(), bytes.end()); }
  /// The next whole payload, or nothing until more bytes come.
  std::optional<std::vector<std::uint8_t>> next();
  /// Gives up waiting for the rest of a frame that has begun and looks behind its start; for when an answer is overdue.
  /// Afterwards nothing waits, unless a frame was found.
  std::optional<std::vector<std::uint8_t>> rescue();
  size_t dropped() const { return dropped_; }  ///< bytes that belonged to no frame
  size_t waiting() const { return waiting_.size(); }

 private:
  void drop(size_t count);
  std::vector<std::uint8_t> waiting_;
  size_t dropped_ = 0;
};

}  // namespace breakaway
