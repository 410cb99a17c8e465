#include "fuzz/imported.h"

using namespace breakaway;
using namespace breakaway::test;

/// A log of any kind but those that need a process each, fuzz_mat's and fuzz_hdf5's.
static const Fuzzed import("import", [](std::string_view bytes) {
  if (bytes.starts_with("MATLAB ") || bytes.starts_with("\x89HDF")) return;
  requireSound(readTableBytes(std::string(bytes), "log"));
});
