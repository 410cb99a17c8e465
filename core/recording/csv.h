// Recordings as CSV (resources/help/files.md): `# key: value` lines, one header line, rows; an empty cell is a missing
// value.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "recording/recording.h"

namespace breakaway {

/// Reads this form only; other forms come in through import. Errors name the file, the row (1 is the first
/// row after the header, blank lines not counted) and the column. `nan` is a missing value like an empty cell;
/// infinities are refused. A column that columns.h doesn't name may hold anything: what is no number is a
/// missing value there, and a comma within double quotes separates nothing.
Result<Recording> readCsv(const std::string& path);
Result<Recording> readCsvText(std::string_view text, const std::string& name);

/// Writes all channels with the shortest text that reads back to the same double; to a temporary name, then renamed.
Result<void> writeCsv(const Recording& recording, const std::string& path);

/// The text of the `time_s` column as it stands in the content of a file, one per row. Errors name the file `name`.
Result<std::vector<std::string>> timeTextIn(std::string_view text, const std::string& name);

}  // namespace breakaway
