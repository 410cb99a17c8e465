// The Cortex-M3's own timer, counting processor clocks, polled.
#pragma once

#include <cstdint>

namespace breakaway {

class SysTick {
 public:
  static constexpr std::uint32_t span = 1u << 24;  ///< clocks until it starts again

  SysTick() {
    at(0x14) = span - 1;  // reload
    at(0x18) = 0;
    at(0x10) = 1u | 4u;  // on, processor clock, no interrupt
  }
  /// Grows with time, from 0 to span − 1 and again.
  std::uint32_t now() const { return span - 1 - at(0x18); }
  static std::uint32_t between(std::uint32_t earlier, std::uint32_t later) { return (later - earlier) & (span - 1); }

 private:
  static volatile std::uint32_t& at(std::uintptr_t reg) {
    return *reinterpret_cast<volatile std::uint32_t*>(0xe000e000u +
                                                      reg);  // NOLINT(performance-no-int-to-ptr): a register
  }
};

}  // namespace breakaway
