// The map's columns (resources/help/files.md): one list that all its files share.
#pragma once

#include <string>
#include <vector>

#include "friction/friction_map.h"

namespace breakaway {

struct MapColumn {
  std::string name;
  std::vector<double> values;  ///< one per bin
};

/// All columns in the file's order.
std::vector<MapColumn> mapTable(const FrictionMap& map);

/// Fills map.bins, of map.axis, from columns of equal length by name; returns the name of the first column that is
/// missing, or nothing.
std::string fillFromTable(FrictionMap& map, const std::vector<MapColumn>& columns);

}  // namespace breakaway
