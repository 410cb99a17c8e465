// What a debugger or an emulator does for a program on the chip. Freestanding. Source: Arm, "Semihosting for AArch32
// and AArch64", 2020, chapter 5.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace breakaway {

inline std::uintptr_t semihosting(std::uintptr_t operation, std::uintptr_t parameter) {
  register std::uintptr_t call asm("r0") = operation;
  register std::uintptr_t told asm("r1") = parameter;
  asm volatile("bkpt 0xab" : "+r"(call) : "r"(told) : "memory");
  return call;
}

inline void leaveEmulator() {
  constexpr std::uintptr_t exit = 0x18, applicationExit = 0x20026;
  semihosting(exit, applicationExit);
}

/// Through the emulator's console, in one piece each, what ends with a zero and has none before: an emulated serial
/// port sends byte by byte, each of which takes an emulator a system call.
inline void sendByConsole(std::span<const std::uint8_t> bytes) {
  constexpr std::uintptr_t writeByte = 0x03, writeText = 0x04;
  while (!bytes.empty()) {
    std::size_t length = 0;
    while (bytes[length] != 0) ++length;
    if (length > 0) semihosting(writeText, reinterpret_cast<std::uintptr_t>(bytes.data()));
    semihosting(writeByte, reinterpret_cast<std::uintptr_t>(bytes.data() + length));
    bytes = bytes.subspan(length + 1);
  }
}

}  // namespace breakaway
