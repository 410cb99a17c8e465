// What the files of a run say: their kinds, results with intervals, findings, whose motor, and where they come from.
#pragma once

#include <string>

#include "base/result.h"
#include "project/run.h"

namespace breakaway {

/// Looks through all files in `folder` (run.json aside) and fills kind, motor, device, at, by, command, verdict,
/// findings, values and files. A JSON file with another `schema` than a map, motor, diagnosis, tuning, bench or model
/// is listed and otherwise left alone. Errors: a file can't be read; files come from several runs.
Result<ProjectRun> contentsOf(const std::string& folder);

/// The `motor_serial` of a bench file; empty where there is none, or the file can't be read.
std::string motorSerialIn(const std::string& benchFile);

/// The name of a file's kind by its name and, for JSON, by its schema's: "breakaway.map/1" is a map.
std::string kindOfFile(const std::string& path);

}  // namespace breakaway
