// Excel workbooks (.xlsx): zip archives of XML.
#pragma once

#include <string>

#include "base/result.h"
#include "recording/import/raw_table.h"
#include "recording/import/zip_archive.h"

namespace breakaway {

bool isWorkbook(const ZipArchive& archive);

/// The sheet that has the most numbers, read as a table of text is: names before the rows, a row of units, what
/// precedes and follows left out. Cells of dates and times are s; formulas count as their stored values. Errors, at
/// `name`: damaged, no sheet with a table.
Result<RawTable> readWorkbook(const ZipArchive& archive, const std::string& name);

}  // namespace breakaway
