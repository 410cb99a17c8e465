#include "recording/import/sentence_rows.h"

#include <algorithm>
#include <map>
#include <vector>

#include "recording/import/column_name.h"
#include "recording/import/sentence_parts.h"
#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

/// The names of the values' columns; empty where they name no motion and no time.
std::vector<std::string> namesOf(const Sentence& sentence) {
  std::vector<std::string> names;
  std::string_view unit;
  size_t known = 0, labelled = 0, clocks = 0;
  for (size_t k = 0; k < sentence.values.size(); ++k) {
    std::string name = labelIn(sentence.texts[k], unit);
    if (isClock(sentence.values[k]) || (clocks == 0 && isStamp(sentence, k))) {
      unit = k == 0 && !isClock(sentence.values[k]) ? stampUnit(sentence) : std::string_view{};
      name = unit.empty() ? "time" : "time [" + std::string(unit) + "]";
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
      bool clock = false;
      for (size_t k = 0; k < sentence.values.size(); ++k)
        clock = clock || isClock(sentence.values[k]) || isStamp(sentence, k);
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
