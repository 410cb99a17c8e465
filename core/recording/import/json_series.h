// JSON of signals that have stamps of their own each.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "recording/import/json_cells.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// {"speed": {"x": […], "y": […]}, …}, and [{"name": "speed", "unit": "rpm", "values": [[t, v], …]}, …]: of pairs the
/// one that goes on rising is the stamp. Nothing: the JSON holds no such signal.
std::optional<Result<RawTable>> readSeries(const Json& json, const std::string& name);

}  // namespace breakaway
