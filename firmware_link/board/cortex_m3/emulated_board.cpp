// The emulated board: the reference firmware on a Cortex-M3, and its rig in the same image.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "emulated_rig_data.h"
#include "firmware_link/board/cortex_m3/cmsdk_uart.h"
#include "firmware_link/board/cortex_m3/emulated_bench.h"
#include "firmware_link/board/cortex_m3/semihosting.h"
#include "firmware_link/board/cortex_m3/sys_tick.h"
#include "firmware_link/board/reference_board.h"

namespace breakaway {

namespace {

#ifdef BREAKAWAY_REAL_PACE
constexpr board::Pace pace = board::Pace::real;
#else
constexpr board::Pace pace = board::Pace::granted;
#endif
constexpr int mostIdle =
    200;  // rounds before the chip sleeps: the host answers soon, and waking takes the emulator time
constexpr std::uint32_t clockRate_Hz = 25'000'000;  // of the machine mps2-an385

#ifdef BREAKAWAY_SENDS_BY_CONSOLE
/// What the board has to send at once; its outbox holds whole frames.
class Sender {
 public:
  static bool idle() { return true; }
  template <typename Board>
  void send(const CmsdkUart& /*uart*/, Board& board) {
    while (const std::size_t size = board.transmit(waiting_)) sendByConsole(std::span(waiting_).first(size));
  }

 private:
  std::array<std::uint8_t, 4096> waiting_{};
};
#else
/// What has left the board and not yet the chip.
class Sender {
 public:
  bool idle() const { return sent_ == filled_; }
  template <typename Board>
  void send(const CmsdkUart& uart, Board& board) {
    for (;;) {
      if (idle()) {
        sent_ = 0;
        filled_ = board.transmit(waiting_);
      }
      if (idle() || !uart.hasRoom()) return;
      uart.send(waiting_[sent_++]);
    }
  }

 private:
  std::array<std::uint8_t, 512> waiting_{};
  std::size_t filled_ = 0, sent_ = 0;
};
#endif

/// Whole ticks of the wall's time. What an emulator was kept from for longer than a tenth of a second is left out.
class TickClock {
 public:
  bool due(const SysTick& timer) {
    const std::uint32_t now = timer.now();
    behind_ += SysTick::between(seen_, now);
    seen_ = now;
    if (behind_ > clockRate_Hz / 10) behind_ = clockRate_Hz / 10;
    if (behind_ < perTick) return false;
    behind_ -= perTick;
    return true;
  }

 private:
  static constexpr auto perTick = static_cast<std::uint32_t>(emulatedRig.tick_s * clockRate_Hz + 0.5f);
  std::uint32_t seen_ = 0, behind_ = 0;
};

void say(const CmsdkUart& uart, const char* text) {
  for (; *text != '\0'; ++text) {
    while (!uart.hasRoom()) {
    }
    uart.send(static_cast<std::uint8_t>(*text));
  }
}

/// How long the first byte took to come is different after each powering up.
std::uint16_t bootNumber(const CmsdkUart& uart, const SysTick& timer) {
  while (!uart.hasByte()) {
  }
  const std::uint32_t clocks = timer.now();
  return static_cast<std::uint16_t>(clocks ^ (clocks >> 16));
}

[[noreturn]] void serve() {
  asm volatile("cpsid i");
  const CmsdkUart uart;
  const SysTick timer;
  say(uart, "Breakaway's reference board, emulated\r\n");
  board::BoardHardware<float> hardware = emulatedHardware;
  hardware.pace = pace;
  hardware.boot = bootNumber(uart, timer);
  static board::ReferenceBoard<float> board(hardware);
  static EmulatedBench bench(emulatedRig, 1);
  static Sender sender;
  TickClock clock;
  int idle = 0;  // times in a row that there was nothing to do
  for (;;) {
    if (idle > mostIdle) uart.waitForByte();
    while (uart.hasByte()) {
      const std::uint8_t byte = uart.byte();
      board.receive(std::span(&byte, 1));
    }
    sender.send(uart, board);
    const bool ticks = pace == board::Pace::real ? clock.due(timer) : sender.idle() && board.mayTick();
    if (ticks) bench.advance(board.tick(bench.readings()));
    const bool waits = pace == board::Pace::granted && !ticks && sender.idle();
    idle = waits ? idle + 1 : 0;
  }
}

}  // namespace

}  // namespace breakaway

extern "C" void runImage() {
  breakaway::serve();
}
