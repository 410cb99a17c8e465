#include <span>

#include "firmware_link/wire/frame.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

static std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Bytes as they come from a line: frames or counted errors.
static const Fuzzed frames("wire", [](std::string_view bytes) {
  wire::FrameDecoder decoder;
  std::uint32_t good = 0;
  for (const std::uint8_t byte : bytesOf(bytes)) {
    if (!decoder.take(byte)) continue;
    ++good;
    const wire::Frame frame = decoder.frame();
    std::uint8_t again[wire::mostFrame];
    require(wire::FrameEncoder::encode(frame, again) > 0, "a frame that came can be sent");
  }
  require(good == decoder.counts().good, "every good frame is given once");
});
