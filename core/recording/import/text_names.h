// The names of a text table's columns, from the lines before its first row.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "recording/import/text_layout.h"

namespace breakaway {

struct TextNames {
  std::vector<std::string> names;  ///< one per column; "column_1", … where the file has none
  std::vector<std::string> units;  ///< from a line of their own; empty texts elsewhere
  bool found = false;
};

/// `before`: the lines before the first row, the last one directly before it, comments among them; `firstRow` tells the
/// names where each cell has a label. Names may stand in one line or two (groups above, names below), a line of units
/// below them, whatever units it holds; they may be parted otherwise than the rows, or stand behind a comment mark.
TextNames namesBefore(const std::vector<std::string_view>& before, std::string_view firstRow, const TextLayout& layout);

/// Whether the line holds one name per column and no number.
bool isNamesLine(std::string_view line, const TextLayout& layout);

}  // namespace breakaway
