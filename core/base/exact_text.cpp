#include "base/exact_text.h"

#include <charconv>

namespace breakaway {

std::string exactText(double value) {
  std::string text;
  appendExact(text, value);
  return text;
}

void appendExact(std::string& text, double value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

}  // namespace breakaway
