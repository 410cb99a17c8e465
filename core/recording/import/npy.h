// NumPy's arrays: .npy, and .npz, which is a zip archive of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "recording/import/raw_table.h"
#include "recording/import/zip_archive.h"

namespace breakaway {

bool isNpy(std::string_view bytes);

/// The array's columns: a vector under `name`, the columns of a matrix as `NAME_1`, …, the fields of records under
/// their own names. Whole numbers beyond a double's digits are counted from the first; dates are times in s. Errors, at
/// `place`: damaged, cut short, other than real numbers.
Result<std::vector<RawColumn>> readNpy(std::string_view bytes, const std::string& name, const std::string& place);

/// Whether the archive holds arrays.
bool isNpz(const ZipArchive& archive);

/// All arrays as long as the longest; single values become notes.
Result<RawTable> readNpz(const ZipArchive& archive, const std::string& place);

/// Columns as long as the longest make a table, single values notes; others are left out with a remark.
Result<RawTable> tableOfColumns(std::vector<RawColumn> columns, const std::string& place);

}  // namespace breakaway
