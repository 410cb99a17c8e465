// From what people have on disk to a recording in the columns of columns.h.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "recording/recording.h"

namespace breakaway {

/// What the technician says about one column: value = scale × old value + offset, under the name `to`.
struct ColumnRule {
  std::string to;
  double scale = 1.0;
  double offset = 0.0;
};

/// By the column's name in the file; `{"columns": {"OLD": {"to": "NEW", "scale": 1.0, "offset": 0.0}}}`.
using ImportMap = std::map<std::string, ColumnRule>;

struct Imported {
  Recording recording;
  std::vector<std::string> remarks;  ///< what became of each column, what was assumed and what was left out, in words
};

Result<ImportMap> readImportMap(const std::string& path);

/// Reads a text table, a MATLAB file or a JSON log (told apart by their content), renames and converts the columns by
/// `map` first, then as a log that is known, then by their names and units. Time without a unit whose median step is
/// 0.5 or more is taken for ms, from 100 on for µs; times of day are counted from the first row. An angle that starts
/// anew with each turn goes on counting. Columns that mean nothing to the contract keep their name and values. Errors:
/// what the readers say; a map that names no column of the file; no time; neither angle nor position; times that don't
/// increase.
Result<Imported> importRecording(const std::string& path, const ImportMap& map = {});

}  // namespace breakaway
