#include "fuzz/fuzzed.h"
#include "plant/rig.h"

using namespace breakaway;
using namespace breakaway::test;

static const Fuzzed rig("rig", [](std::string_view bytes) {
  const auto read = readRigText(std::string(bytes), "f.rig.json");
  if (!read) return requireOneLine(read.error().message());
  require(read->loopRate_Hz > 0.0, "a rig that is read can run");
});
