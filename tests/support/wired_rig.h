// Presets' rigs with something wrong at their terminals.
#pragma once

#include <QtGlobal>
#include <string>

#include "base/atomic_file.h"
#include "firmware_link/presets.h"

namespace breakaway::test {

/// With `to` in place of `from`, which must be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  if (at == std::string::npos) qFatal("no %s", from.c_str());
  return text.replace(at, from.size(), to);
}

/// A preset's rig file as text, with `wiring` as the entries of its field of that name.
inline std::string wiredRig(const std::string& preset, const std::string& wiring) {
  const auto file = rigFileOf("simulated:" + preset);
  if (!file) qFatal("%s", file.error().message().c_str());
  const auto text = readFile(*file);
  if (!text) qFatal("%s", text.error().message().c_str());
  return replaced(*text, "{", "{ \"wiring\": [" + wiring + "],");
}

}  // namespace breakaway::test
