#include <cstddef>
#include <cstdint>

#include "fuzz/fuzzed.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  for (const auto& [name, reader] : breakaway::test::fuzzedReaders())
    reader({reinterpret_cast<const char*>(data), size});
  return 0;
}
