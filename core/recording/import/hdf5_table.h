// HDF5 files, MATLAB's of version 7.3 among them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

bool isHdf5(std::string_view bytes);

/// All data sets of numbers: vectors under their path ("motor/position"), the columns of a matrix as `PATH_1`, …, the
/// fields of records as `PATH.FIELD`; those as long as the longest are columns, single values notes. An attribute
/// "units" or "unit" tells the unit. The file is read in a process of its own. Errors, at `name`: damaged, no
/// numbers.
Result<RawTable> readHdf5(std::string_view content, const std::string& name);

/// The columns alone, of whatever length; none when there are none. With `matlab` they are the variables of a MATLAB
/// file: fields of structures are "STRUCT.FIELD", the columns of a matrix MATLAB's, texts and cells left out.
Result<std::vector<RawColumn>> readHdf5Columns(std::string_view content, const std::string& name, bool matlab);

}  // namespace breakaway
