// The characterisation logs of robot teams: SysId's JSON of four tests.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "recording/import/read_table.h"

namespace breakaway {

/// Reads tests ("slow-forward", "fast-backward", …), each an array of rows: all one after the other, each a part of its
/// own, in the units that the file names. Rows are time, voltage, position, velocity; of a drive train's rows the left
/// side is named "left", the right one "right". Nothing for text that holds no such tests.
std::optional<Result<ReadTable>> readSysId(const std::string& text, const std::string& name);

}  // namespace breakaway
