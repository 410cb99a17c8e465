// All that is left to chance in a foreign rig: repeatable from its family and seed.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace breakaway::test {

class Draw {
 public:
  Draw(const std::string& family, std::uint64_t seed) {
    std::uint64_t mixed = seed * 7919 + 17;
    for (const char one : family) mixed = mixed * 131 + static_cast<unsigned char>(one);
    bits_.seed(mixed);
  }
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits_); }
  double evenly(double low, double high) { return low * std::exp(between(0.0, std::log(high / low))); }  ///< by ratio
  double normal() { return std::normal_distribution<double>()(bits_); }
  bool chance(double part) { return between(0.0, 1.0) < part; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(bits_); }
  template <typename T, size_t n>
  T oneOf(const std::array<T, n>& all) {
    return all[static_cast<size_t>(whole(0, static_cast<int>(n) - 1))];
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace breakaway::test
