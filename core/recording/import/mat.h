// MATLAB files, versions 5 (also compressed) and 7.3, as named vectors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "recording/recording.h"

namespace breakaway {

/// All real numeric arrays of the file, in its order: vectors and scalars under their name, the columns of a matrix as
/// `NAME_1`, `NAME_2`, …, the fields of a structure as `NAME.FIELD`. Texts, cells and complex arrays are left out. The
/// file is read in a process of its own: whatever a damaged file does to the library, here it is one line. Errors, at
/// `name`: no MATLAB file, cut short, damaged, no numbers.
Result<std::vector<Channel>> readMat(std::string_view content, const std::string& name);

}  // namespace breakaway
