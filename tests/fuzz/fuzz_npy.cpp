#include "fuzz/imported.h"
#include "recording/import/npy.h"

using namespace breakaway;
using namespace breakaway::test;

/// A NumPy array, whatever its header claims.
static const Fuzzed npy("npy", [](std::string_view bytes) {
  auto columns = readNpy(bytes, "column", "log");
  if (!columns) return requireOneLine(columns.error().message());
  requireSound(tableOfColumns(std::move(*columns), "log"));
});
