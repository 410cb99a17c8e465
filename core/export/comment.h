// Text from outside, such as a path, in the comment of a language.
#pragma once

#include <string>

namespace breakaway {

/// One line that ends no comment: of C, of XML, or by its own end.
inline std::string commentable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  }
  for (const char* end : {"*/", "--"}) {
    for (size_t at = text.find(end); at != std::string::npos; at = text.find(end)) text.insert(at + 1, " ");
  }
  return text;
}

}  // namespace breakaway
