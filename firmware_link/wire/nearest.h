// Whole numbers from their bits, which costs a processor without floating point least. Freestanding.
#pragma once

#include <bit>
#include <cstdint>

namespace breakaway::wire {

/// The nearest whole number, halves away from zero; held within ±2^23, where what is no number is, too.
constexpr std::int32_t nearest(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const int exponent = static_cast<int>(bits >> 23 & 0xffu);
  std::uint32_t size = 0;
  if (exponent >= 127 + 23) {
    size = 1u << 23;
  } else if (exponent >= 126) {
    const int shift = 150 - exponent;
    size = ((bits & 0x7fffffu) + 0x800000u + (1u << (shift - 1))) >> shift;
  }
  return (bits >> 31) != 0 ? -static_cast<std::int32_t>(size) : static_cast<std::int32_t>(size);
}
constexpr std::int32_t nearest(double value) {
  constexpr double most = 8388608.0;
  if (!(value < most)) return 1 << 23;
  if (value < -most) return -(1 << 23);
  return static_cast<std::int32_t>(value < 0.0 ? value - 0.5 : value + 0.5);
}

}  // namespace breakaway::wire
