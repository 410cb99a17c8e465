// The reference firmware on an LPC1768. Compiles and links here; nobody here has run it on the chip.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/board/cortex_m3/sys_tick.h"
#include "firmware_link/board/lpc1768/peripherals.h"
#include "firmware_link/board/reference_board.h"

namespace breakaway::lpc1768 {

namespace {

constexpr auto clocksPerTick = static_cast<std::uint32_t>(tick_s * clock_Hz + 0.5f);

/// The chip's own number in hexadecimal, as its boot ROM tells it; empty where it refuses.
const char* serialNumber() {
  static std::array<char, 33> text{};
  std::array<std::uint32_t, 5> question{rom::readSerialNumber}, answer{};
  rom::call(question.data(), answer.data());
  if (answer[0] != 0) return "";
  for (std::size_t k = 0; k < 32; ++k) text[k] = "0123456789abcdef"[answer[1 + k / 8] >> (28 - 4 * (k % 8)) & 15u];
  return text.data();
}

[[noreturn]] void serve() {
  startClock();
  const Uart uart;
  const Converter converter;
  Encoder encoder;
  Bridge bridge;
  board::BoardHardware<float> hardware = wiredHardware();
  at(clock::kept0) = at(clock::kept0) + 1;
  hardware.serialNumber = serialNumber();
  hardware.boot = static_cast<std::uint16_t>(at(clock::kept0));
  // Its constructor sets all of it: this memory isn't cleared at power-up.
  [[gnu::section(".ahb")]] static board::ReferenceBoard<float, 2048, 4096> board(hardware);
  const SysTick timer;
  std::uint32_t seen = timer.now(), behind = 0;
  for (;;) {
    const std::uint32_t now = timer.now();
    behind += SysTick::between(seen, now);
    seen = now;
    if (behind >= clocksPerTick) {
      // A tick that came late is not made up for: two at once would be one that is too long.
      behind = behind < 2 * clocksPerTick ? behind - clocksPerTick : 0;
      bridge.set(board.tick({encoder.count(), encoder.indexPassed(), converter.current_A(), converter.supply_V(), 0}));
    }
    while (uart.hasByte()) {
      const std::uint8_t byte = uart.byte();
      board.receive(std::span(&byte, 1));
    }
    if (uart.isIdle()) {
      std::array<std::uint8_t, 16> next;
      const std::size_t count = board.transmit(next);
      for (std::size_t k = 0; k < count; ++k) uart.send(next[k]);
    }
  }
}

}  // namespace

}  // namespace breakaway::lpc1768

extern "C" void runImage() {
  breakaway::lpc1768::serve();
}
