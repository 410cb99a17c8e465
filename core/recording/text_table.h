// Tables of text in whatever form they come: commas, semicolons, tabs or blanks, decimal point or comma, UTF-8 or
// UTF-16.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/raw_table.h"

namespace breakaway {

/// Finds separator, decimal mark and header by looking at the rows, and reads the table. Lines before the header, and
/// those that begin with # or %, are no part of it. A second header line of units is joined to the names as "name
/// [unit]"; a header that is itself a comment is understood. Without any header the columns are column_1, column_2, ….
/// Words for a missing value (nan, NA, null, -) are missing; true and false are 1 and 0. A last line that is cut short
/// is left out with a remark. Errors: no table, a row with another number of cells.
Result<RawTable> readTextTable(std::string_view text, const std::string& name);

}  // namespace breakaway
