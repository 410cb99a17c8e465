// Where the simulated rigs lie.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// The folder `resources`: BREAKAWAY_RESOURCES, else ../resources, ../../../resources or ../share/breakaway
/// from the program's own folder, else /usr/share/breakaway; empty when there is none.
std::string resourcesFolder();

/// The names NAME of all presets/NAME.rig.json, sorted.
std::vector<std::string> presetNames();

bool isSimulated(const std::string& uri);

/// The rig file that `simulated`, `simulated:PRESET` or `simulated:FILE.rig.json` names; an error names the presets
/// there are.
Result<std::string> rigFileOf(const std::string& uri);

/// The bench file that belongs to a rig file, beside it: NAME.bench.json for NAME.rig.json; empty when there is none.
std::string benchFileBeside(const std::string& rigFile);

}  // namespace breakaway
