#include "fuzz/imported.h"
#include "recording/import/wpilog.h"

using namespace breakaway;
using namespace breakaway::test;

/// A robot controller's log.
static const Fuzzed wpilog("wpilog", [](std::string_view bytes) { requireSound(readWpilog(bytes, "log")); });
