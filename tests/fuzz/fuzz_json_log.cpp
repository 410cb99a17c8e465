#include "fuzz/imported.h"
#include "recording/import/json_log.h"

using namespace breakaway;
using namespace breakaway::test;

/// A log in JSON of any shape.
static const Fuzzed json("json_log",
                         [](std::string_view bytes) { requireSound(readJsonLog(std::string(bytes), "log")); });
