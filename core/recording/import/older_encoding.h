// Text in other encodings than Unicode and Windows-1252.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

/// The text in UTF-8 if it is Chinese, Japanese, Korean, Russian or one of eastern Europe's languages in an encoding of
/// old (GB 18030, Big5, Shift JIS, EUC-KR, Windows-1251, Windows-1250), told by the words of quantities that it holds
/// then, more of them than in Windows-1252; nothing else is. Bytes that are none of that encoding become "?".
std::optional<std::string> fromOlderEncoding(std::string_view text);

}  // namespace breakaway
