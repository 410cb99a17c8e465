// Clock, encoder, converter, bridge and serial port of the LPC1768, polled. Pins: encoder P1.20, P1.23, index P1.24;
// current AD0.0 (P0.23), supply AD0.1 (P0.24); bridge PWM1.1 (P2.0) and PWM1.2 (P2.1), its enable P2.2; serial port 0
// (P0.2, P0.3).
#pragma once

#include <cstdint>

#include "firmware_link/board/board_hardware.h"
#include "firmware_link/board/lpc1768/registers.h"
#include "firmware_link/board/lpc1768/wiring.h"

namespace breakaway::lpc1768 {

inline constexpr std::uint32_t clock_Hz = 96'000'000;
inline constexpr std::uint32_t pwmSteps = 4800;  // 20 kHz

/// 12 MHz crystal · 2 · 12 / 1 = 288 MHz, / 3 = 96 MHz; every peripheral in use at the processor's clock.
inline void startClock() {
  const auto feed = [] {
    at(clocks::pllFeed) = 0xAA;
    at(clocks::pllFeed) = 0x55;
  };
  at(clocks::oscillator) = 1u << 5;
  while ((at(clocks::oscillator) & (1u << 6)) == 0) {
  }
  at(clocks::processorDivider) = 3 - 1;
  at(clocks::source) = 1;
  at(clocks::pllSetting) = 12 - 1;
  feed();
  at(clocks::pllControl) = 1;
  feed();
  while ((at(clocks::pllState) & (1u << 26)) == 0) {
  }
  at(clocks::pllControl) = 3;
  feed();
  // Full clock: UART 0 bits 6:7, PWM 1 bits 12:13, converter bits 24:25 an eighth, encoder bits 0:1 of the second.
  at(clocks::peripherals0) = 1u << 6 | 1u << 12 | 3u << 24;
  at(clocks::peripherals1) = 1u << 0;
  at(clocks::power) |= 1u << 3 | 1u << 6 | 1u << 9 | 1u << 12 | 1u << 18;
}

inline void connect(unsigned port, unsigned pin, std::uint32_t function) {
  volatile std::uint32_t& two = at(pins::function0 + 8u * port + 4u * (pin / 16));
  const unsigned shift = 2 * (pin % 16);
  two = (two & ~(3u << shift)) | function << shift;
}

class Encoder {
 public:
  Encoder() {
    connect(1, 20, 1), connect(1, 23, 1), connect(1, 24, 1);
    at(encoder::setting) = 1u << 2;  // four counts per line
    at(encoder::filter) = 8;
    at(encoder::mostPosition) = 0xFFFFFFFFu;
    at(encoder::control) = 1u | 8u;  // position and index count from 0
  }
  std::int32_t count() const { return static_cast<std::int32_t>(at(encoder::position)); }
  bool indexPassed() {
    const std::uint32_t seen = at(encoder::indexCount);
    const bool passed = seen != seen_;
    seen_ = seen;
    return passed;
  }

 private:
  std::uint32_t seen_ = 0;
};

/// Both channels in turn, without end.
class Converter {
 public:
  Converter() {
    connect(0, 23, 1), connect(0, 24, 1);
    at(adc::control) = 3u | 0u << 8 | 1u << 16 | 1u << 21;  // 12 MHz: 65 clocks each, 5.4 µs
  }
  float current_A() const { return (volts(adc::channel0) * sensorDivider - sensorMiddle_V) / sensor_V_per_A; }
  float supply_V() const { return volts(adc::channel1) * supplyDivider; }

 private:
  static float volts(std::uintptr_t channel) {
    return static_cast<float>(at(channel) >> 4 & 0xFFFu) * (adcReference_V / 4096.0f);
  }
};

/// One leg switches, the other one is held low; all open while the enable is low.
class Bridge {
 public:
  Bridge() {
    at(gpio::clear2) = 1u << 2;
    at(gpio::direction2) |= 1u << 2;
    connect(2, 0, 1), connect(2, 1, 1);
    at(pwm::prescale) = 0;
    at(pwm::matchControl) = 2;  // starts again at match 0
    at(pwm::match0) = pwmSteps;
    at(pwm::match1) = 0;
    at(pwm::match2) = 0;
    at(pwm::latch) = 7;
    at(pwm::outputs) = 1u << 9 | 1u << 10;
    at(pwm::control) = 1u | 8u;
  }
  void set(const board::Drive<float>& drive) {
    if (!drive.enabled) at(gpio::clear2) = 1u << 2;
    const auto steps =
        static_cast<std::int32_t>(drive.duty * static_cast<float>(pwmSteps) + (drive.duty < 0.0f ? -0.5f : 0.5f));
    at(pwm::match1) = drive.enabled && steps > 0 ? static_cast<std::uint32_t>(steps) : 0;
    at(pwm::match2) = drive.enabled && steps < 0 ? static_cast<std::uint32_t>(-steps) : 0;
    at(pwm::latch) = 6;
    if (drive.enabled) at(gpio::set2) = 1u << 2;
  }
};

/// 2 Mbaud, 8N1.
class Uart {
 public:
  Uart() {
    connect(0, 2, 1), connect(0, 3, 1);
    at(uart::line) = 0x83;
    at(uart::divisorLow) = 3;  // 96 MHz / (16 · 3)
    at(uart::divisorHigh) = 0;
    at(uart::fraction) = 0x10;
    at(uart::line) = 0x03;
    at(uart::fifo) = 0x07;
  }
  bool hasByte() const { return (at(uart::state) & 1u) != 0; }
  std::uint8_t byte() const { return static_cast<std::uint8_t>(at(uart::data)); }
  /// The chip's own queue is empty and takes 16 bytes.
  bool isIdle() const { return (at(uart::state) & 0x20u) != 0; }
  void send(std::uint8_t value) const { at(uart::data) = value; }
};

}  // namespace breakaway::lpc1768
