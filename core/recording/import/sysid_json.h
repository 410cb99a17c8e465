// The characterisation logs of robot teams: SysId's JSON of four tests.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/result.h"
#include "recording/import/read_table.h"

namespace breakaway {

/// Whether the object holds tests ("slow-forward", "fast-backward", …), each an array of rows.
bool isSysId(const nlohmann::ordered_json& json);

/// All tests one after the other, each a part of its own, in the units that the file names. Rows are time, voltage,
/// position, velocity; of a drive train's rows the left side is named "left", the right one "right".
Result<ReadTable> readSysId(const nlohmann::ordered_json& json, const std::string& name);

}  // namespace breakaway
