// Tables whose lines all begin with the same mark: "@D 0,12,11", "DATA: 0,12,11".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

struct MarkedLines {
  std::string text;  ///< the lines without the mark
  std::string mark;
};

/// The text without the mark with which nearly all of its lines begin, parted by a blank from numbers that other
/// marks part; nothing where there is none.
std::optional<MarkedLines> withoutMarkOfLines(std::string_view text);

}  // namespace breakaway
