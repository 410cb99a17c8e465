// Repeatable random numbers, the same on every machine.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/numbers.h"

namespace breakaway {

/// What random numbers are for: under one seed each purpose has a stream of its own, so that what one draws doesn't
/// shift the others.
enum class Stream : std::uint64_t {
  whole = 0,                       ///< all that one seed gives
  currentNoise = 0x5eed5eed5eed,   ///< of a current sensor
  breakawayScatter = 0x5ca77e4ed,  ///< of static friction, from one standstill to the next
  trialFamily = 0xfa311e,          ///< which kind of trial a seed stands for
};

/// Uniform and normal numbers from SplitMix64 (S. Vigna's public domain algorithm), normal ones by Box and Muller's
/// transform.
class Random {
 public:
  explicit Random(std::uint64_t seed, Stream stream = Stream::whole)
      : state_(seed ^ static_cast<std::uint64_t>(stream)) {}

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// Normal with mean 0 and variance 1.
  double normal() {
    if (hasSpare_) {
      hasSpare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = turn_rad * uniform();
    spare_ = radius * std::sin(angle);
    hasSpare_ = true;
    return radius * std::cos(angle);
  }

  /// 0 … limit − 1, evenly.
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(uniform() * static_cast<double>(limit)); }

 private:
  std::uint64_t state_;
  double spare_ = 0.0;
  bool hasSpare_ = false;
};

}  // namespace breakaway
