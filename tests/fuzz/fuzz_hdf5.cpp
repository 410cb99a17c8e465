#include "fuzz/imported.h"
#include "recording/import/hdf5_table.h"

using namespace breakaway;
using namespace breakaway::test;

/// An HDF5 file, however damaged, is a table or one line.
static const Fuzzed hdf5("hdf5", [](std::string_view bytes) { requireSound(readHdf5(bytes, "log")); });
