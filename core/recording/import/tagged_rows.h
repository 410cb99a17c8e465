// Rows of several tables in turn, each beginning with its table's word: "ESC, 1200, 1450" beside "ATT, 1210, 0.3, 2.1".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

struct TaggedRows {
  std::string table;
  std::string word;    ///< with which the table's rows begin
  size_t leftOut = 0;  ///< lines that begin otherwise
};

/// The rows of the table whose names tell most of a motion, as a table. Names stand in a line that begins with the
/// table's word, or behind it in one of "FMT" (ArduPilot's). Nothing: fewer than two tables have names and rows, or
/// none tells a motion.
std::optional<TaggedRows> withTaggedRowsApart(std::string_view text);

}  // namespace breakaway
