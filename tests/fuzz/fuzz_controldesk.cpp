#include "fuzz/imported.h"
#include "recording/import/controldesk.h"

using namespace breakaway;
using namespace breakaway::test;

/// Any bytes taken for a ControlDesk recording.
static const Fuzzed controldesk("controldesk", [](std::string_view bytes) {
  if (auto table = readControlDeskText(bytes, '\n', "log")) requireSound(std::move(*table));
});
