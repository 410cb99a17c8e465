#include "diagnose/simulate/model_file.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

/// A model that is read is written so that it reads again, and the second writing is the first.
static const Fuzzed model("model", [](std::string_view bytes) {
  const auto read = readModel(fileWith(bytes, "model.json"));
  if (!read) return requireOneLine(read.error().message());
  const std::string text = modelText(*read);
  const auto again = readModel(fileWith(text, "model.json"));
  require(again.ok(), "what was written reads back");
  require(modelText(*again) == text, "the second writing is the first");
});
