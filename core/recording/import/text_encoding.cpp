#include "recording/import/text_encoding.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "recording/import/older_encoding.h"

namespace breakaway {

namespace {

/// What Windows-1252 has at 0x80 … 0x9F.
constexpr std::array<char16_t, 32> windows1252{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                               0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,
                                               0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                               0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

void append(std::string& out, unsigned code) {
  if (code < 0x80U) {
    out += static_cast<char>(code);
  } else if (code < 0x800U) {
    out += static_cast<char>(0xC0U | (code >> 6U));
    out += static_cast<char>(0x80U | (code & 0x3FU));
  } else {
    const bool half = code >= 0xD800U && code < 0xE000U;  // half of a pair: nothing in a log's numbers, names or units
    const unsigned shown = half ? 0xFFFDU : code;
    out += static_cast<char>(0xE0U | (shown >> 12U));
    out += static_cast<char>(0x80U | ((shown >> 6U) & 0x3FU));
    out += static_cast<char>(0x80U | (shown & 0x3FU));
  }
}

std::string fromUtf16(std::string_view text, size_t from, bool little) {
  std::string out;
  out.reserve(text.size() / 2);
  for (size_t k = from; k + 1 < text.size(); k += 2) {
    const auto low = static_cast<unsigned char>(text[k + (little ? 0 : 1)]);
    append(out, low + 256U * static_cast<unsigned char>(text[k + (little ? 1 : 0)]));
  }
  return out;
}

/// How many of the first bytes at even or odd places are zero, of 1.
double zeros(std::string_view text, size_t first) {
  size_t count = 0, all = 0;
  for (size_t k = first; k < std::min<size_t>(text.size(), 400); k += 2, ++all) count += text[k] == '\0' ? 1 : 0;
  return all == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(all);
}

/// Typographers' minus as a number has it.
std::string_view withPlainMinus(std::string_view text, std::string& buffer) {
  constexpr std::string_view minus = "\xE2\x88\x92";
  size_t at = text.find(minus);
  if (at == std::string_view::npos) return text;
  buffer.clear();
  buffer.reserve(text.size());
  for (; at != std::string_view::npos; at = text.find(minus)) {
    buffer += text.substr(0, at);
    buffer += '-';
    text.remove_prefix(at + minus.size());
  }
  return buffer += text;
}

/// Without a terminal's colours: ESC, "[", numbers, a letter.
std::string_view withoutColours(std::string_view text, std::string& buffer) {
  constexpr std::string_view begin = "\x1B[";
  size_t at = text.find(begin);
  if (at == std::string_view::npos) return text;
  std::string out;
  out.reserve(text.size());
  for (; at != std::string_view::npos; at = text.find(begin)) {
    out += text.substr(0, at);
    const size_t end = text.find_first_not_of("0123456789;?", at + begin.size());
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  out += text;
  return buffer = std::move(out);
}

std::string_view decoded(std::string_view text, std::string& buffer);

}  // namespace

bool isUtf8(std::string_view text) {
  const auto at = [&text](size_t k) { return static_cast<unsigned char>(text[k]); };
  for (size_t k = 0; k < text.size();) {
    if (k + 8 <= text.size()) {  // eight plain letters at once
      unsigned long long eight = 0;
      std::memcpy(&eight, text.data() + k, 8);
      if ((eight & 0x8080808080808080ULL) == 0) {
        k += 8;
        continue;
      }
    }
    const unsigned char first = at(k);
    const size_t more = first < 0x80U                     ? 0
                        : first >= 0xC2U && first < 0xE0U ? 1
                        : first >= 0xE0U && first < 0xF0U ? 2
                        : first >= 0xF0U && first < 0xF5U ? 3
                                                          : 9;
    if (more == 9 || k + more >= text.size() + (more == 0 ? 1 : 0)) return false;
    for (size_t m = 1; m <= more; ++m) {
      if ((at(k + m) & 0xC0U) != 0x80U) return false;
    }
    k += more + 1;
  }
  return true;
}

std::string_view inUtf8(std::string_view text, std::string& buffer) {
  return withoutColours(decoded(text, buffer), buffer);
}

namespace {

std::string_view decoded(std::string_view text, std::string& buffer) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const bool little = text.starts_with("\xFF\xFE"), big = text.starts_with("\xFE\xFF");
  if (little || big) return buffer = fromUtf16(text, 2, little);
  if (zeros(text, 1) > 0.6 && zeros(text, 0) < 0.1) return buffer = fromUtf16(text, 0, true);
  if (zeros(text, 0) > 0.6 && zeros(text, 1) < 0.1) return buffer = fromUtf16(text, 0, false);
  if (isUtf8(text)) return withPlainMinus(text, buffer);
  if (auto older = fromOlderEncoding(text)) return buffer = std::move(*older);
  buffer.clear();
  buffer.reserve(text.size() + text.size() / 16);
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    append(buffer, code >= 0x80U && code < 0xA0U ? windows1252[code - 0x80U] : code);
  }
  return buffer;
}

}  // namespace

}  // namespace breakaway
