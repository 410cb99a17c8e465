// Cells that hold lists, as programs write messages with arrays: "[1.5, 2.5]", "array('d', [1.5])".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

/// The text with each list of numbers in cells of its own, and their names numbered: "position" becomes "position[0]",
/// "position[1]"; a list of one keeps its name. Nothing where no cell holds a list, or one's length changes.
std::optional<std::string> withListsInCells(std::string_view text);

}  // namespace breakaway
