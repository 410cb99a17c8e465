// Lines that begin with a stamp, as loggers put it: "[12.345] angle=0.3", "I (12345) motor: angle=0.3",
// "2024-05-01 10:20:10,123 - INFO - angle=0.3".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

/// The text with each line's stamp as its first labelled cell, "time:12.345, angle=0.3", and without the tag behind it;
/// lines that have none are left out. Nothing: most lines don't begin so, or have no labels behind it.
std::optional<std::string> withStampsAsCells(std::string_view text);

/// The text with each line's stamp in brackets as its first cell, "[12.345] 0.3,1.5" as "12.345,0.3,1.5"; words,
/// with a stamp or without, are names, of which the first is the time's. Nothing: most lines don't begin with a stamp
/// and a number.
std::optional<std::string> withStampsBeforeRows(std::string_view text);

}  // namespace breakaway
