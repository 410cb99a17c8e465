// The map as a MATLAB file.
#pragma once

#include <string>

#include "base/result.h"
#include "friction/friction_map.h"

namespace breakaway {

/// Writes a version 5 .mat: each column of map.csv as a vector of its name, and the averages; to a temporary name, then
/// renamed.
Result<void> writeMapMat(const FrictionMap& map, const std::string& path);

}  // namespace breakaway
