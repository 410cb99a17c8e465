// JSON whose signals are arrays: by name, by index, or as lists of rows.
#pragma once

#include <string>

#include "base/result.h"
#include "recording/import/json_cells.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// {"time": […], "angle": […]}, also an object deeper; lists of lists, one per row or one per signal, become NAME[0],
/// NAME[1] ….
Result<RawTable> arraysOf(const Json& json, const std::string& name);

/// Whether the rows are but one of several arrays by name that are as long: {"time": […], "joints": [[…], […]]}.
bool isTableOfArrays(const Json& json, const Json& rows);

/// {"time": {"0": 0.1, "1": 0.2}, …}, as pandas writes it.
bool isByIndex(const Json& json);
Result<RawTable> byIndex(const Json& json, const std::string& name);

bool isArrayOfRows(const Json& array);
/// Rows, with the names of their columns beside them.
Result<RawTable> rowsOf(const Json& json, const Json& rows, const std::string& name);

}  // namespace breakaway
