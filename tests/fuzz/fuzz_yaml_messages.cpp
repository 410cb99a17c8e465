#include "fuzz/imported.h"
#include "recording/import/yaml_messages.h"

using namespace breakaway;
using namespace breakaway::test;

/// Any bytes taken for messages as YAML.
static const Fuzzed yaml("yaml_messages", [](std::string_view bytes) {
  if (auto table = readYamlMessages(bytes, "log")) requireSound(std::move(*table));
});
