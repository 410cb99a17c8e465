#include "fuzz/fuzzed.h"
#include "recording/import/import_map.h"

using namespace breakaway;
using namespace breakaway::test;

/// A map that is read names what each column becomes, and no factor of 0; written it reads again as the same.
static const Fuzzed importMap("import_map", [](std::string_view bytes) {
  const auto read = readImportMapText(std::string(bytes), "f.json");
  if (!read) return requireOneLine(read.error().message());
  for (const auto& [name, rule] : read->columns)
    require(!rule.to.empty() && rule.scale != 0.0, "a rule makes a column");
  for (const auto& [name, sign] : read->sign) require(sign == 1.0 || sign == -1.0, "a sign is 1 or -1");
  const std::string text = importMapText(*read);
  const auto again = readImportMapText(text, "g.json");
  require(again.ok(), "what was written reads back");
  require(importMapText(*again) == text, "the second writing is the first");
});
