#include "base/result.h"

namespace breakaway {

namespace {

/// Control characters as a field's or a file's name may hold them: "\x0a".
std::string spelledOut(const std::string& text) {
  constexpr const char* digits = "0123456789abcdef";
  std::string out;
  for (const char one : text) {
    const auto code = static_cast<unsigned char>(one);
    if (code >= 0x20 && code != 0x7f) {
      out += one;
    } else {
      out += "\\x";
      out += digits[code >> 4];
      out += digits[code & 0xf];
    }
  }
  return out;
}

}  // namespace

std::string Error::message() const {
  return said();
}

Message Error::said() const {
  const Message whole = place.empty() ? Message(fact) : place + ": " + fact;
  const std::string line = spelledOut(whole);
  return line == whole.english() ? whole : Message(line);
}

}  // namespace breakaway
