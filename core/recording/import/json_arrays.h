// Logs in JSON that hold columns or rows instead of samples.
#pragma once

#include <string>

#include "base/result.h"
#include "recording/import/json_cells.h"

namespace breakaway {

/// {"time": […], "angle": […]}, also an object deeper; lists of lists, one per row or one per signal, become NAME[0],
/// NAME[1] ….
Result<RawTable> arraysOf(const JsonInOrder& json, const std::string& name);
/// Whether the rows are but one of several arrays by name that are as long: {"time": […], "joints": [[…], […]]}.
bool isTableOfArrays(const JsonInOrder& json, const JsonInOrder& rows);

/// {"time": {"0": 0.1, "1": 0.2}, …}, as pandas writes it.
bool isByIndex(const JsonInOrder& json);
Result<RawTable> byIndex(const JsonInOrder& json, const std::string& name);

bool isArrayOfRows(const JsonInOrder& array);
/// Rows, with the names of their columns beside them.
Result<RawTable> rowsOf(const JsonInOrder& json, const JsonInOrder& rows, const std::string& name);

}  // namespace breakaway
