// Logs in JSON, whatever shape they have.
#pragma once

#include <string>

#include "base/result.h"
#include "recording/import/read_table.h"

namespace breakaway {

/// Reads an array of objects, one per sample, bare or in a field ("entries", "samples", "data", or the longest there
/// is); one object per line; arrays by name, `{"time": […], "angle": […]}`; rows with their names beside them (pandas'
/// "split"); pandas' objects by index; and SysId's tests, rows of time, voltage, position and velocity, in the units
/// that the file names. Objects within samples are flattened, "servo_stats.position". Plain values beside the samples
/// become notes. true and false are 1 and 0. Errors: no JSON (with the line), nested deeper than 100, no log, an entry
/// that lacks a field.
Result<ReadTable> readJsonLog(const std::string& text, const std::string& name);

}  // namespace breakaway
