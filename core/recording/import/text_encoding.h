// Text of whatever encoding as UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace breakaway {

/// `text` itself, without a byte order mark, where it is UTF-8; else what it says in UTF-8, put into `buffer`: UTF-16
/// with its mark or with every other byte zero, East Asian and eastern European encodings, and Windows-1252 for all
/// else; without a terminal's colours.
std::string_view inUtf8(std::string_view text, std::string& buffer);

/// Whether the bytes are UTF-8.
bool isUtf8(std::string_view text);

}  // namespace breakaway
