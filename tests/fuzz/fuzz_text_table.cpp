#include "fuzz/imported.h"
#include "recording/import/text_table.h"

using namespace breakaway;
using namespace breakaway::test;

/// Any bytes taken for a table of text.
static const Fuzzed text("text_table", [](std::string_view bytes) { requireSound(readTextTable(bytes, "log")); });
