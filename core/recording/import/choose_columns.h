// Which of a log's columns become which of a recording.
#pragma once

#include <vector>

#include "base/result.h"
#include "recording/import/column_name.h"
#include "recording/import/import_map.h"
#include "recording/import/known_tools.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// What is to become of one column.
struct Choice {
  ColumnName name;  ///< not understood: the column keeps its name and is not used
  bool byMap = false;
  bool byTool = false;
  bool dropped = false;  ///< leaves the recording altogether
};

/// One per column. The map goes first, then the tool, then names and units; of several columns for the same thing the
/// one with the contract's own name is taken, else the one that tells most, else the first. Columns of another axis
/// than the angle's are set aside, and so are times that don't increase. Errors, at `place`: the map names a column
/// that isn't there, or two for the same thing; a column of text is used.
Result<std::vector<Choice>> chooseColumns(const RawTable& table, const ImportMap& map, const ToolColumns& tool,
                                          const std::string& place);

/// "to" and factor of a map's rule.
ColumnName nameOf(const ColumnRule& rule);

}  // namespace breakaway
