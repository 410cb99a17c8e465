#include "recording/import/older_encoding.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>

#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

struct Close {
  void operator()(void* converter) const { iconv_close(converter); }
};

/// All of the text, "?" where a byte is none of that encoding; `faults` counts those.
std::optional<std::string> converted(std::string_view text, const char* encoding, size_t& faults) {
  iconv_t opened = iconv_open("UTF-8", encoding);
  if (opened == reinterpret_cast<iconv_t>(-1)) return std::nullopt;  // NOLINT(performance-no-int-to-ptr): iconv's own
  const std::unique_ptr<void, Close> converter(opened);
  std::string in(text), out;
  char* from = in.data();
  size_t left = in.size();
  std::array<char, 4096> part{};
  while (left > 0) {
    char* to = part.data();
    size_t room = part.size();
    const size_t done = iconv(opened, &from, &left, &to, &room);
    out.append(part.data(), part.size() - room);
    if (done != static_cast<size_t>(-1) || errno == E2BIG) continue;
    ++faults;
    out += '?';
    ++from;
    --left;
  }
  return out;
}

}  // namespace

std::optional<std::string> fromOlderEncoding(std::string_view text) {
  constexpr size_t looksAt = 20000, fewestWords = 2;
  std::string_view head = text.substr(0, looksAt);
  if (head.size() < text.size()) head = head.substr(0, head.find_last_of('\n') + 1);
  const auto wordsIn = [head](const char* encoding) -> size_t {
    size_t faults = 0;
    const auto tried = converted(head, encoding, faults);
    const size_t words = tried ? foreignWordsIn(*tried) : 0;
    return words > faults ? words - faults : 0;
  };
  const char* best = nullptr;
  size_t most = std::max(wordsIn("CP1252"), fewestWords - 1);
  for (const char* encoding : {"GB18030", "BIG5", "SHIFT_JIS", "EUC-KR", "CP1251", "CP1250"}) {
    const size_t words = wordsIn(encoding);
    if (words <= most) continue;
    most = words;
    best = encoding;
  }
  if (best == nullptr) return std::nullopt;
  size_t faults = 0;
  return converted(text, best, faults);
}

}  // namespace breakaway
