// UART 0 of the machine mps2-an385 (Arm CMSDK APB UART), polled.
#pragma once

#include <cstdint>

namespace breakaway {

class CmsdkUart {
 public:
  CmsdkUart() {
    at(baudDivider) = 16;
    at(control) = 1u | 2u;  // transmit, receive
  }
  bool hasByte() const { return (at(state) & 2u) != 0; }
  std::uint8_t byte() const { return static_cast<std::uint8_t>(at(data)); }
  bool hasRoom() const { return (at(state) & 1u) == 0; }
  void send(std::uint8_t value) const { at(data) = value; }

 private:
  static constexpr std::uintptr_t data = 0x00, state = 0x04, control = 0x08, baudDivider = 0x10;
  static volatile std::uint32_t& at(std::uintptr_t reg) {
    return *reinterpret_cast<volatile std::uint32_t*>(0x40004000u +
                                                      reg);  // NOLINT(performance-no-int-to-ptr): a register
  }
};

}  // namespace breakaway
