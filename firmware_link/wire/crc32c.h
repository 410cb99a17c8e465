// CRC-32C, the checksum at the end of every frame. Freestanding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace breakaway::wire {

/// Castagnoli's polynomial 0x1EDC6F41, bits reflected, start and end inverted; "123456789" gives 0xE3069283. Source:
/// Castagnoli, Bräuer, Herrmann, "Optimization of cyclic redundancy-check codes with 24 and 32 parity bits", IEEE
/// Trans. Communications 41(6), 1993; parameters as in RFC 3720, appendix B.4. Finds any 5 wrong bits in a frame of
/// ours, and misses one in 2³² of the worse ones.
class Crc32c {
 public:
  constexpr void add(std::uint8_t byte) { state_ = (state_ >> 8) ^ table()[(state_ ^ byte) & 0xFFu]; }
  constexpr void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) add(byte);
  }
  constexpr std::uint32_t value() const { return ~state_; }

 private:
  static constexpr std::array<std::uint32_t, 256> computed() {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t k = 0; k < 256; ++k) {
      std::uint32_t word = k;
      for (int bit = 0; bit < 8; ++bit) word = (word >> 1) ^ ((word & 1u) != 0 ? 0x82F63B78u : 0u);
      made[k] = word;
    }
    return made;
  }
  static constexpr const std::array<std::uint32_t, 256>& table() { return words_; }
  static const std::array<std::uint32_t, 256> words_;

  std::uint32_t state_ = 0xFFFFFFFFu;
};

inline constexpr std::array<std::uint32_t, 256> Crc32c::words_ = Crc32c::computed();

constexpr std::uint32_t crc32c(std::span<const std::uint8_t> bytes) {
  Crc32c crc;
  crc.add(bytes);
  return crc.value();
}

}  // namespace breakaway::wire
