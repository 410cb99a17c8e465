#include "fuzz/imported.h"
#include "recording/import/codesys_trace.h"

using namespace breakaway;
using namespace breakaway::test;

/// Any bytes behind the first line of a CODESYS trace.
static const Fuzzed codesys("codesys_trace", [](std::string_view bytes) {
  const std::string trace = "[key]; [value]\n" + std::string(bytes);
  if (auto table = readCodesysTrace(trace, '\n', "log")) requireSound(std::move(*table));
});
