// The LPC1768's registers that the port uses. Source: NXP, UM10360 "LPC176x/5x User manual", rev. 4.1, 2016; the
// chapter stands beside each.
#pragma once

#include <cstdint>

namespace breakaway::lpc1768 {

inline volatile std::uint32_t& at(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);  // NOLINT(performance-no-int-to-ptr): a register
}

/// Chapter 32, in-application programming: functions of the boot ROM. Five words in, five out, the first of which is 0
/// where it was done.
namespace rom {
inline constexpr std::uint32_t readSerialNumber = 58;

inline void call(std::uint32_t* question, std::uint32_t* answer) {
  using Entry = void (*)(std::uint32_t*, std::uint32_t*);
  reinterpret_cast<Entry>(0x1FFF1FF1)(question, answer);  // NOLINT(performance-no-int-to-ptr): its place in the chip
}
}  // namespace rom
/// Chapter 4, clocks and power.
namespace clocks {
inline constexpr std::uintptr_t pllControl = 0x400FC080, pllSetting = 0x400FC084, pllState = 0x400FC088,
                                pllFeed = 0x400FC08C, power = 0x400FC0C4, processorDivider = 0x400FC104,
                                source = 0x400FC10C, peripherals0 = 0x400FC1A8, peripherals1 = 0x400FC1AC,
                                oscillator = 0x400FC1A0;
}
/// Chapter 8, what a pin is connected to; two bits each.
namespace pins {
inline constexpr std::uintptr_t function0 = 0x4002C000;  // P0.0 … P0.15; the next 16 pins 4 bytes on
}
/// Chapter 9.
namespace gpio {
inline constexpr std::uintptr_t direction2 = 0x2009C040, set2 = 0x2009C058, clear2 = 0x2009C05C;
}
/// Chapter 14, UART 0.
namespace uart {
inline constexpr std::uintptr_t data = 0x4000C000, divisorLow = 0x4000C000, divisorHigh = 0x4000C004, fifo = 0x4000C008,
                                line = 0x4000C00C, state = 0x4000C014, fraction = 0x4000C028;
}
/// Chapter 24, PWM 1.
namespace pwm {
inline constexpr std::uintptr_t control = 0x40018004, prescale = 0x4001800C, match0 = 0x40018018, match1 = 0x4001801C,
                                match2 = 0x40018020, matchControl = 0x40018014, outputs = 0x4001804C,
                                latch = 0x40018050;
}
/// Chapter 26, quadrature encoder.
namespace encoder {
inline constexpr std::uintptr_t control = 0x400BC000, setting = 0x400BC008, position = 0x400BC00C,
                                mostPosition = 0x400BC010, indexCount = 0x400BC020, filter = 0x400BC03C;
}
/// Chapter 27, real-time clock: a word that outlives a reset.
namespace clock {
inline constexpr std::uintptr_t kept0 = 0x40024044;
}
/// Chapter 29, converter.
namespace adc {
inline constexpr std::uintptr_t control = 0x40034000, channel0 = 0x40034010, channel1 = 0x40034014;
}

}  // namespace breakaway::lpc1768
