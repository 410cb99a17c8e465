#include "recording/import/sentence_parts.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "recording/import/text_layout.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Letters and what is written within words: "M1" and "0x1F" are no numbers, nor is the end of "1.5.2".
bool continuesWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool hasForm(std::string_view text, std::string_view form) {
  if (text.size() < form.size()) return false;
  for (size_t k = 0; k < form.size(); ++k) {
    const bool same = form[k] == '0' ? isDigit(text[k]) : text[k] == form[k] || (form[k] == ' ' && text[k] == 'T');
    if (!same) return false;
  }
  return true;
}

/// The length of "2024-05-01 10:20:10,125" or "10:20:10.5" at the text's begin; 0 where neither stands.
size_t clockSize(std::string_view text) {
  for (const std::string_view form : {"0000-00-00 00:00:00", "00:00:00", "0:00:00"}) {
    if (!hasForm(text, form)) continue;
    size_t end = form.size();
    const bool fraction = hasForm(text.substr(end), ",000") || hasForm(text.substr(end), ".0");
    if (fraction) end = std::min(text.find_first_not_of("0123456789", end + 1), text.size());
    return end;
  }
  return 0;
}

/// Where the value that begins at `at` ends: a number, or a clock; `at` where none begins.
size_t endOfValue(std::string_view line, size_t at) {
  if (const size_t clock = clockSize(line.substr(at)); clock > 0) return at + clock;
  size_t end = at;
  if (end < line.size() && (line[end] == '-' || line[end] == '+')) ++end;
  if (end >= line.size() || !isDigit(line[end])) return at;
  const auto takeDigits = [&] {
    while (end < line.size() && isDigit(line[end])) ++end;
  };
  takeDigits();
  if (end + 1 < line.size() && line[end] == '.' && isDigit(line[end + 1])) {
    ++end;
    takeDigits();
  }
  if (end + 1 < line.size() && (line[end] == 'e' || line[end] == 'E')) {
    const size_t digits = line[end + 1] == '-' || line[end + 1] == '+' ? end + 2 : end + 1;
    if (digits < line.size() && isDigit(line[digits])) {
      end = digits;
      takeDigits();
    }
  }
  return end;
}

/// The words of a text, without the marks around them.
std::vector<std::string_view> wordsIn(std::string_view text) {
  constexpr std::string_view between = " \t,;:=|()[]{}<>\"'!?";
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const size_t begin = text.find_first_not_of(between);
    if (begin == std::string_view::npos) break;
    const size_t end = std::min(text.find_first_of(between, begin), text.size());
    std::string_view word = text.substr(begin, end - begin);
    while (!word.empty() && (word.back() == '.' || word.back() == '-')) word.remove_suffix(1);
    if (!word.empty()) words.push_back(word);
    text.remove_prefix(end);
  }
  return words;
}

}  // namespace

Sentence parted(std::string_view line) {
  Sentence out;
  size_t from = 0, at = 0;
  while (at < line.size()) {
    const size_t end = at > 0 && continuesWord(line[at - 1]) ? at : endOfValue(line, at);
    if (end == at) {
      ++at;
      continue;
    }
    out.texts.push_back(line.substr(from, at - from));
    out.values.push_back(line.substr(at, end - at));
    from = at = end;
  }
  out.texts.push_back(line.substr(from));
  return out;
}

std::string reading(const Sentence& sentence) {
  std::string out;
  for (const std::string_view text : sentence.texts) {
    for (const char c : withoutBlanks(text)) {
      if (std::isspace(static_cast<unsigned char>(c)) == 0) out += c;
    }
    out += '\n';
  }
  return out;
}

bool isClock(std::string_view value) {
  return value.find(':') != std::string_view::npos;
}

std::string_view unitIn(std::string_view behind) {
  const auto words = wordsIn(behind);
  if (words.empty() || unitNamed(words.front()) == nullptr) return {};
  // ", RPM: 5" names the next value.
  const std::string_view unit = words.front();
  const auto at = static_cast<size_t>(unit.data() - behind.data());
  const std::string_view after = withoutBlanks(behind.substr(at + unit.size()));
  const bool next = behind.substr(0, at).find_first_of(",;|") != std::string_view::npos ||
                    (!after.empty() && (after.front() == ':' || after.front() == '='));
  return next ? std::string_view{} : unit;
}

std::string_view stampUnit(const Sentence& sentence) {
  if (!withoutBlanks(sentence.texts[0]).empty()) return {};
  const std::string_view behind = withoutBlanks(sentence.texts[1]);
  const std::string_view word = behind.substr(0, behind.find_first_of(" :,;|"));
  const Unit* unit = unitNamed(word);
  return unit != nullptr && unit->kind == UnitKind::time ? word : std::string_view{};
}

bool isStamp(const Sentence& sentence, size_t k) {
  const std::string_view before = withoutBlanks(sentence.texts[k]), behind = withoutBlanks(sentence.texts[k + 1]);
  if (before.ends_with('[') && behind.starts_with(']')) return before == "[" || before.ends_with(" [");
  return k == 0 && !stampUnit(sentence).empty();
}

std::string labelIn(std::string_view text, std::string_view unitBefore) {
  for (size_t open = text.find('['); open != std::string_view::npos; open = text.find('[')) {
    const size_t close = text.find(']', open);  // "[motor_driver]: pos": whose it is
    if (close == std::string_view::npos || withoutBlanks(text.substr(close + 1)).size() < 2) break;
    text.remove_prefix(close + 1);
  }
  static constexpr auto fillers = std::to_array<std::string_view>(
      {"is", "at", "the", "and", "was", "are", "with", "of", "now", "a", "an", "has", "reads", "equals", "to"});
  std::string label;
  auto words = wordsIn(text);
  if (!unitBefore.empty() && !words.empty()) words.erase(words.begin());
  for (const std::string_view word : words) {
    const bool filler =
        std::any_of(fillers.begin(), fillers.end(), [word](std::string_view one) { return isSameWord(word, one); });
    if (!filler) label += (label.empty() ? "" : " ") + std::string(word);
  }
  return label;
}

}  // namespace breakaway
