// Friction maps as files: map.json and map.csv (resources/help/files.md), a C header, a MATLAB file.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "friction/friction_map.h"

namespace breakaway {

/// What exportMap() knows.
const std::vector<std::string>& mapForms();

/// Writes the map as `format`: csv, json, c-header, mat or modelica. `name`, an identifier: what all names of the
/// header begin with, breakaway where it is empty, or the package's. Errors: an unknown format (the known ones are
/// named), the file.
Result<void> exportMap(const FrictionMap& map, const std::string& format, const std::string& path,
                       const std::string& name = {});

/// Reads `breakaway.map/1`. Errors name the file and the field, or the bin.
Result<FrictionMap> readMap(const std::string& path);
Result<FrictionMap> readMapText(const std::string& text, const std::string& place);

}  // namespace breakaway
