#include "base/shard.h"
#include "firmware_link/transport/byte_address.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

/// A board's address, and as the other short text of a command line a shard.
static const Fuzzed uri("uri", [](std::string_view bytes) {
  if (const auto address = byteAddressOf(std::string(bytes)); !address) requireOneLine(address.error().message());
  const auto shard = parseShard(std::string(bytes));
  if (!shard) return requireOneLine(shard.error().message());
  size_t held = 0;
  for (size_t k = 0; k < 100; ++k) held += shard->holds(k) ? 1 : 0;
  require(held <= 100, "a shard holds a part");
});
