// What is asked of any JSON text before it is taken apart: sound, not nested without end, no field twice.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace breakaway {

/// Levels of brackets within brackets that are read; what is deeper would end in the stack.
constexpr int deepestJson = 100;

/// Why `text` can't be read as JSON, with the line: it isn't JSON, nests deeper than deepestJson, has a field twice in
/// one object, or a number beyond a double. `place` stands before the line.
std::optional<Error> jsonFault(std::string_view text, const std::string& place);

/// True when brackets outside of strings nest deeper than deepestJson, in JSON or in anything like it.
bool nestsTooDeep(std::string_view text);

/// `text` with U+FFFD for what is no UTF-8: names from boards, paths and files as they may stand in a JSON file.
std::string asUtf8(const std::string& text);

}  // namespace breakaway
