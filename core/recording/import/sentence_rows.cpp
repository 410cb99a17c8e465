#include "recording/import/sentence_rows.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <vector>

#include "recording/import/column_name.h"
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

/// A line as its values and the texts before, between and behind them: one text more than values.
struct Sentence {
  std::vector<std::string_view> values, texts;
};

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

/// What the texts say, however many blanks stand in them.
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

/// The words of a text, without the marks around them.
std::vector<std::string_view> wordsIn(std::string_view text) {
  constexpr std::string_view between = " \t,;:=|()[]<>\"'!?";
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

/// The unit that stands behind a value.
std::string_view unitIn(std::string_view behind) {
  const auto words = wordsIn(behind);
  const bool own = !words.empty() && unitNamed(words.front()) != nullptr;
  return own ? words.front() : std::string_view{};
}

/// The words before a value without the unit of the one before and what only makes it a sentence.
std::string labelIn(std::string_view text, std::string_view unitBefore) {
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

/// The names of the values' columns; empty where they name no motion and no time.
std::vector<std::string> namesOf(const Sentence& sentence) {
  std::vector<std::string> names;
  std::string_view unit;
  size_t known = 0, labelled = 0, clocks = 0;
  for (size_t k = 0; k < sentence.values.size(); ++k) {
    std::string name = labelIn(sentence.texts[k], unit);
    if (isClock(sentence.values[k])) {
      name = "time";
      unit = {};
      ++clocks;
    } else {
      labelled += name.empty() ? 0 : 1;
      unit = unitIn(sentence.texts[k + 1]);
      if (understandName(name, unit).understood()) ++known;
      if (!unit.empty()) name += " [" + std::string(unit) + "]";
    }
    names.push_back(name.empty() ? "column " + std::to_string(k + 1) : name);
  }
  const bool table = known > 0 && names.size() > 1 && 2 * labelled >= names.size() - clocks;
  return table ? names : std::vector<std::string>{};
}

}  // namespace

std::optional<SentenceRows> withSentencesAsCells(std::string_view text, SentenceTime time) {
  constexpr size_t looksAt = 20, mostValues = 200;
  const char lineEnd = lineEndOf(text);
  std::map<std::string, size_t> readings;
  std::string_view ahead = text;
  size_t lines = 0;
  while (!ahead.empty() && lines < looksAt) {
    const std::string_view line = takeLine(ahead, lineEnd);
    if (withoutBlanks(line).empty()) continue;
    ++lines;
    ++readings[reading(parted(line))];
  }
  const auto usual = std::max_element(readings.begin(), readings.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
  if (usual == readings.end() || 2 * usual->second <= lines || usual->second < 3) return std::nullopt;
  SentenceRows out;
  while (!text.empty()) {
    const std::string_view line = takeLine(text, lineEnd);
    const Sentence sentence = parted(line);
    if (reading(sentence) != usual->first) {
      out.leftOut += withoutBlanks(line).empty() ? 0 : 1;
      continue;
    }
    if (out.table.empty()) {
      const bool clock = std::any_of(sentence.values.begin(), sentence.values.end(), isClock);
      const auto names = namesOf(sentence);
      if (names.empty() || names.size() > mostValues || (time == SentenceTime::clock && !clock)) return std::nullopt;
      for (const std::string& name : names) out.table += name + ";";
      out.table.back() = '\n';
    }
    for (const std::string_view value : sentence.values) out.table += std::string(value) + ";";
    out.table.back() = '\n';
  }
  return out;
}

}  // namespace breakaway
