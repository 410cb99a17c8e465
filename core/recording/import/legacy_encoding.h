// Text in the encodings that East Asian programs write where it isn't Unicode.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

/// The text in UTF-8 if it is Chinese, Japanese or Korean in such an encoding (GB 18030, Big5, Shift JIS, EUC-KR), told
/// by the words of quantities that it holds then; nothing else is. Bytes that are none of that encoding become "?".
std::optional<std::string> fromEastAsian(std::string_view text);

}  // namespace breakaway
