// Logs of other tools in JSON: one object per sample.
#pragma once

#include <string>

#include "base/result.h"
#include "recording/raw_table.h"

namespace breakaway {

/// Reads `{…, "entries": [{"timestamp": 0.1, "position": 0.2, …}, …]}` or the bare array: one column per field of the
/// first entry, numbers as they are, true and false as 1 and 0. Plain values beside the entries become notes. Errors:
/// no JSON (with the line), no entries, an entry that lacks a field.
Result<RawTable> readJsonLog(const std::string& text, const std::string& name);

}  // namespace breakaway
