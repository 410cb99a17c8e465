// Sizes and limits. A float's are told from its bits, which costs a processor without floating point least.
// Freestanding.
#pragma once

#include <bit>
#include <cstdint>

namespace breakaway {

constexpr float magnitude(float value) {
  return __builtin_fabsf(value);
}
constexpr double magnitude(double value) {
  return __builtin_fabs(value);
}

/// |value| > |limit|. What is no number exceeds every limit.
constexpr bool exceeds(double value, double limit) {
  return !(__builtin_fabs(value) <= __builtin_fabs(limit));
}
constexpr bool exceeds(float value, float limit) {
  constexpr std::uint32_t size = 0x7fffffff;  // floats of one sign are ordered as their bits are
  return (std::bit_cast<std::uint32_t>(value) & size) > (std::bit_cast<std::uint32_t>(limit) & size);
}

constexpr bool isNegative(float value) {
  return (std::bit_cast<std::uint32_t>(value) >> 31) != 0;
}
constexpr bool isNegative(double value) {
  return (std::bit_cast<std::uint64_t>(value) >> 63) != 0;
}

/// Holds a value within ±limit.
constexpr float within(float value, float limit) {
  return !exceeds(value, limit) ? value : isNegative(value) ? -limit : limit;
}
constexpr double within(double value, double limit) {
  return value > limit ? limit : value < -limit ? -limit : value;
}

}  // namespace breakaway
