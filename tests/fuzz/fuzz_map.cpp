#include "friction/map_export.h"
#include "friction/map_json.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

/// A map that is read must be written so that it reads again, and the second writing is the first.
static const Fuzzed map("map", [](std::string_view bytes) {
  const auto read = readMapText(std::string(bytes), "f.json");
  if (!read) return requireOneLine(read.error().message());
  const std::string text = mapJsonText(*read);
  const auto again = readMapText(text, "g.json");
  require(again.ok(), "what was written reads back");
  require(mapJsonText(*again) == text, "the second writing is the first");
});
