#include "base/typeset.h"

#include <array>
#include <cstdlib>

namespace breakaway {

namespace {

constexpr const char *minus = "\u2212", *narrowSpace = "\u202f";
constexpr size_t fewestToGroup = 5;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

std::string superscript(int value) {
  static const std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (int rest = std::abs(value); rest > 0 || text.empty(); rest /= 10)
    text.insert(0, digits[static_cast<size_t>(rest % 10)]);
  return (value < 0 ? "⁻" : "") + text;
}

std::string typeset(std::string_view number) {
  std::string out;
  size_t at = 0;
  if (at < number.size() && (number[at] == '-' || number[at] == '+')) out = number[at++] == '-' ? minus : "+";
  const size_t begin = at;
  while (at < number.size() && isDigit(number[at])) ++at;
  const size_t whole = at - begin;
  if (whole == 0) return std::string(number);
  for (size_t k = 0; k < whole; ++k) {
    if (k > 0 && whole >= fewestToGroup && (whole - k) % 3 == 0) out += narrowSpace;
    out += number[begin + k];
  }
  if (at < number.size() && number[at] == '.') {
    const size_t point = at++;
    while (at < number.size() && isDigit(number[at])) ++at;
    out += number.substr(point, at - point);
  }
  if (at + 1 < number.size() && number[at] == 'e') {
    size_t end = at + 1;
    if (number[end] == '-' || number[end] == '+') ++end;
    const size_t digits = end;
    while (end < number.size() && isDigit(number[end])) ++end;
    if (end > digits) {
      const int power = std::atoi(std::string(number.substr(at + 1, end - at - 1)).c_str());
      out += "·10" + superscript(power);
      at = end;
    }
  }
  return out + std::string(number.substr(at));
}

}  // namespace breakaway
