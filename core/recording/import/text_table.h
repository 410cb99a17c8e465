// Tables of text in whatever form they come: commas, semicolons, tabs or blanks, decimal point or comma, any encoding.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Finds the rows by their numbers, and the names before them. What precedes them, text between them and after them is
/// no part of the table; nor are comments (#, %, //), whose "key: value" become notes. Without any names the columns
/// are column_1, column_2, …. Words for a missing value (nan, NA, null, -) are missing; true and false are 1 and 0;
/// times of day and dates are s. A last line that is cut short is left out, up to one row of a hundred with text among
/// its numbers too, and each is said. Errors: no table; more than one row of fifty with another number of cells.
Result<RawTable> readTextTable(std::string_view text, const std::string& name);

}  // namespace breakaway
