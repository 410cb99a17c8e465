#include "experiment/profile.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

/// A profile that is read is written so that it reads again as the same.
static const Fuzzed profile("profile", [](std::string_view bytes) {
  const auto read = readProfileText(std::string(bytes), "f.profile.json");
  if (!read) return requireOneLine(read.error().message());
  const auto again = readProfileText(profileText(*read), "g.profile.json");
  require(again.ok(), "what was written reads back");
  require(profileText(*again) == profileText(*read), "the second writing is the first");
  for (const ProfileRow& row : compareProfiles(*read, *again)) require(row.same, "it differs in nothing from itself");
});
