#include "base/atomic_file.h"
#include "fuzz/fuzzed.h"
#include "motor/bench.h"

using namespace breakaway;
using namespace breakaway::test;

/// A bench that is read must be written so that it reads again, and the second writing is the first.
static const Fuzzed bench("bench", [](std::string_view bytes) {
  const auto read = readBenchText(std::string(bytes), "f.json");
  if (!read) return requireOneLine(read.error().message());
  require(!read->inputChannel().empty(), "a bench names its drive");
  const std::string path = fileWith("", "bench.json");
  require(writeBench(*read, path).ok(), "a bench can be written");
  const auto text = readFile(path);
  const auto again = readBench(path);
  require(again.ok(), "what was written reads back");
  require(writeBench(*again, path).ok() && *readFile(path) == *text, "the second writing is the first");
});
