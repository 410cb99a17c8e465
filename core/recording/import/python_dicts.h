// Python's print of dicts and lists, {'t': 0.1, 'on': True, 'x': None}.
#pragma once

#include <string>
#include <string_view>

namespace breakaway {

/// Begins with a dict's first key in single quotes, so that none of it stands within a text of JSON.
bool isPythonDicts(std::string_view text);
std::string pythonAsJson(std::string_view text);

}  // namespace breakaway
