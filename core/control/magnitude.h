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

/// value > 0, value > limit. What is no number is above whatever is one where its sign is positive.
constexpr bool isPositive(float value) {
  return std::bit_cast<std::int32_t>(value) > 0;
}
constexpr bool isPositive(double value) {
  return value > 0.0;
}
constexpr bool isAbove(double value, double limit) {
  return value > limit;
}
constexpr bool isAbove(float value, float limit) {
  const auto place = [](float of) {  // floats stand in the order of these numbers
    const auto bits = std::bit_cast<std::int32_t>(of);
    return bits < 0 ? static_cast<std::int32_t>(0x80000000u - static_cast<std::uint32_t>(bits)) : bits;
  };
  return place(value) > place(limit);
}
constexpr bool isZero(float value) {
  return (std::bit_cast<std::uint32_t>(value) << 1) == 0;
}
constexpr bool isZero(double value) {
  return value == 0.0;
}

/// Holds a value within ±limit.
constexpr float within(float value, float limit) {
  return !exceeds(value, limit) ? value : isNegative(value) ? -limit : limit;
}
constexpr double within(double value, double limit) {
  return value > limit ? limit : value < -limit ? -limit : value;
}

}  // namespace breakaway
