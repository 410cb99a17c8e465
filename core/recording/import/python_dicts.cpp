#include "recording/import/python_dicts.h"

#include <algorithm>
#include <array>
#include <utility>

namespace breakaway {

bool isPythonDicts(std::string_view text) {
  const size_t brace = text.find_first_not_of("[ \t\r\n");
  if (brace == std::string_view::npos || text[brace] != '{') return false;
  const size_t first = text.find_first_not_of(" \t\r\n", brace + 1);
  return first != std::string_view::npos && text[first] == '\'';
}

std::string pythonAsJson(std::string_view text) {
  static constexpr auto words = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"True", "true"}, {"False", "false"}, {"None", "null"}, {"nan", "null"}, {"inf", "null"}, {"-inf", "null"}});
  std::string json;
  json.reserve(text.size());
  char quote = 0;
  for (size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (quote != 0) {
      if (c == '\\' && k + 1 < text.size()) {
        if (text[k + 1] != '\'') json += c;
        json += text[++k];
      } else if (c == quote) {
        json += '"';
        quote = 0;
      } else {
        json += c == '"' ? "\\\"" : std::string(1, c);
      }
      continue;
    }
    if (c == '\'' || c == '"') {
      quote = c;
      json += '"';
      continue;
    }
    const auto word = std::find_if(words.begin(), words.end(),
                                   [&](const auto& one) { return text.substr(k).starts_with(one.first); });
    json += word == words.end() ? std::string(1, c) : std::string(word->second);
    if (word != words.end()) k += word->first.size() - 1;
  }
  return json;
}

}  // namespace breakaway
