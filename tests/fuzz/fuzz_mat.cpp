#include "fuzz/fuzzed.h"
#include "recording/import/mat.h"

using namespace breakaway;
using namespace breakaway::test;

/// A MATLAB file, however damaged, is named arrays or one line.
static const Fuzzed mat("mat", [](std::string_view bytes) {
  const auto read = readMat(bytes, "f.mat");
  if (!read) return requireOneLine(read.error().message());
  require(!read->empty(), "a file that is read holds an array");
  for (const Channel& one : *read) require(!one.name.empty() && !one.values.empty(), "arrays have a name and values");
});
