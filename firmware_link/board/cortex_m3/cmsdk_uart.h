// UART 0 of the machine mps2-an385 (Arm CMSDK APB UART), polled.
#pragma once

#include <cstdint>

namespace breakaway {

class CmsdkUart {
 public:
  CmsdkUart() {
    at(baudDivider) = 16;
    at(control) = 1u | 2u | 8u;  // transmit, receive, interrupt when received
    interruptEnable() = receiveInterrupt;
  }
  bool hasByte() const { return (at(state) & 2u) != 0; }
  std::uint8_t byte() const { return static_cast<std::uint8_t>(at(data)); }
  bool hasRoom() const { return (at(state) & 1u) == 0; }
  void send(std::uint8_t value) const { at(data) = value; }

  /// Sleeps until a byte is there. The interrupt wakes the processor and is never taken: the caller has masked it.
  void waitForByte() const {
    at(interruptClear) = 2u;
    pendingClear() = receiveInterrupt;
    while (!hasByte()) asm volatile("wfi" ::: "memory");
  }

 private:
  static constexpr std::uintptr_t data = 0x00, state = 0x04, control = 0x08, baudDivider = 0x10;
  static constexpr std::uintptr_t interruptClear = 0x0c;
  static constexpr std::uint32_t receiveInterrupt = 1u << 0;
  static volatile std::uint32_t& at(std::uintptr_t reg) {
    return *reinterpret_cast<volatile std::uint32_t*>(0x40004000u +
                                                      reg);  // NOLINT(performance-no-int-to-ptr): a register
  }
  static volatile std::uint32_t& interruptEnable() {
    return *reinterpret_cast<volatile std::uint32_t*>(0xe000e100u);  // NOLINT(performance-no-int-to-ptr): a register
  }
  static volatile std::uint32_t& pendingClear() {
    return *reinterpret_cast<volatile std::uint32_t*>(0xe000e280u);  // NOLINT(performance-no-int-to-ptr): a register
  }
};

}  // namespace breakaway
