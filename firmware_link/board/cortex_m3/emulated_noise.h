// Seeded noise that costs a board without floating point little. Freestanding.
#pragma once

#include <cstdint>

namespace breakaway {

/// Words from Marsaglia's xorshift ("Xorshift RNGs", J. Statistical Software 8(14), 2003, the triple 13, 17, 5). Normal
/// numbers as the sum of eight uniform ones: variance exact, kurtosis 2.85 instead of 3, nothing beyond 4.9.
class EmulatedNoise {
 public:
  explicit EmulatedNoise(std::uint32_t seed) : state_(seed * 2654435769u + 1u) {
    if (state_ == 0) state_ = 1;
    for (int k = 0; k < 8; ++k) next();
  }

  /// Mean 0, variance 1.
  float normal() {
    std::int32_t sum = 0;
    for (int k = 0; k < 4; ++k) {
      const std::uint32_t word = next();
      sum += static_cast<std::int32_t>(word & 0xffffu) + static_cast<std::int32_t>(word >> 16);
    }
    // Eight uniform halfwords have the mean 8·(2^16 − 1)/2 and the variance 8·(2^32 − 1)/12.
    return static_cast<float>(sum - 262140) * (1.0f / 53509.92f);
  }

 private:
  std::uint32_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }

  std::uint32_t state_;
};

}  // namespace breakaway
