// From reset to runImage() on a Cortex-M3: vectors, memory, constructors. A fault stops the chip, so that an emulator
// ends.
#include <cstdint>

extern "C" {
extern std::uint32_t _stackTop, _dataStart, _dataEnd, _dataLoad, _bssStart, _bssEnd;
extern void (*_constructorsStart[])();
extern void (*_constructorsEnd[])();
void runImage();  // an image's own

[[noreturn]] void resetHandler() {
  const std::uint32_t* from = &_dataLoad;
  for (std::uint32_t* to = &_dataStart; to < &_dataEnd; ++to, ++from) *to = *from;
  for (std::uint32_t* to = &_bssStart; to < &_bssEnd; ++to) *to = 0;
  for (auto construct = _constructorsStart; construct < _constructorsEnd; ++construct) (*construct)();
  runImage();
  for (;;) asm volatile("wfi");
}

[[noreturn]] void faultHandler() {
  asm volatile("cpsid i");
  for (;;) asm volatile("udf #0");  // a fault within a fault: lock-up
}
}

namespace {

union Vector {
  std::uint32_t* stack;
  void (*handler)();
};

[[gnu::section(".vectors"), gnu::used]] const Vector vectors[16] = {
    {.stack = &_stackTop},     {.handler = resetHandler}, {.handler = faultHandler}, {.handler = faultHandler},
    {.handler = faultHandler}, {.handler = faultHandler}, {.handler = faultHandler}, {.handler = nullptr},
    {.handler = nullptr},      {.handler = nullptr},      {.handler = nullptr},      {.handler = faultHandler},
    {.handler = faultHandler}, {.handler = nullptr},      {.handler = faultHandler}, {.handler = faultHandler}};

}  // namespace
