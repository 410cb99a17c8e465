#include <algorithm>

#include "firmware_link/vesc/vesc_frame.h"
#include "firmware_link/vesc/vesc_messages.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

/// Any bytes are frames or dropped bytes, in whatever pieces they come; what is found would be framed as it came.
static const Fuzzed vesc("vesc", [](std::string_view bytes) {
  const std::span whole(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  VescDecoder decoder, pieces;
  std::vector<std::vector<std::uint8_t>> found, again;
  decoder.add(whole);
  size_t taken = 0;
  while (const auto payload = decoder.next()) {
    found.push_back(*payload);
    taken += vescFrame(*payload).size();
    if (const auto values = readVescValues(*payload))
      require(values->fault >= 0 && values->fault < 256, "a fault is a byte");
    if (const auto version = readVescVersion(*payload)) requireOneLine("-" + version->hardware);
  }
  require(decoder.waiting() <= mostVescPayload + 6, "no more waits than a frame");
  const size_t long255 =
      static_cast<size_t>(std::count_if(found.begin(), found.end(), [](const auto& one) { return one.size() == 255; }));
  const size_t accounted = taken + decoder.dropped() + decoder.waiting();
  require(accounted <= whole.size() && accounted + long255 >= whole.size(), "every byte is accounted for");
  for (size_t at = 0; at < whole.size(); at += 3) {
    pieces.add(whole.subspan(at, std::min<size_t>(3, whole.size() - at)));
    while (auto payload = pieces.next()) again.push_back(*payload);
  }
  require(again == found, "pieces don't matter");
  while (decoder.rescue()) {
  }
  require(decoder.waiting() == 0, "nothing waits after a rescue");
});
