// HDF5 files that aren't MATLAB's.
#pragma once

#include <string>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// All data sets of numbers: vectors under their path ("motor/position"), the columns of a matrix as `PATH_1`, …, the
/// fields of records as `PATH.FIELD`; those as long as the longest are columns, single values notes. An attribute
/// "units" or "unit" tells the unit. The file is read in a process of its own. Errors: damaged, no numbers.
Result<RawTable> readHdf5(const std::string& path);

}  // namespace breakaway
