#include "recording/import/tagged_rows.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include "recording/import/column_name.h"
#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

using TaggedCells = std::vector<std::string_view>;

struct Tagged {
  std::vector<std::string> names;
  size_t rows = 0;
};
using Tables = std::map<std::string, Tagged, std::less<>>;

TaggedCells cellsOf(std::string_view line, char separator) {
  TaggedCells cells;
  while (true) {
    const size_t end = line.find(separator);
    cells.push_back(withoutBlanks(line.substr(0, end)));
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
  }
  while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
  return cells;
}

/// Capitals, digits and marks, as programs call their messages; no number, no name of a column.
bool isWord(std::string_view text) {
  if (text.size() < 2 || text.size() > 16) return false;
  const bool begins = std::isupper(static_cast<unsigned char>(text[0])) != 0 || text[0] == '$';
  return begins && std::all_of(text.begin() + 1, text.end(), [](unsigned char c) {
           return std::isupper(c) != 0 || std::isdigit(c) != 0 || c == '_';
         });
}

bool isTaggedNumber(std::string_view cell) {
  TextNumber number;
  return readCell(cell, TextLayout{}, number) == TextCell::number;
}

/// Of the first lines nearly all begin with such a word, and not all with the same.
bool areTagged(std::string_view text, char lineEnd, char separator) {
  constexpr size_t looksAt = 100, fewest = 4;
  size_t lines = 0, tagged = 0;
  std::map<std::string_view, size_t> words;
  while (!text.empty() && lines < looksAt) {
    const std::string_view line = withoutBlanks(takeLine(text, lineEnd));
    if (line.empty()) continue;
    ++lines;
    const size_t end = line.find(separator);
    if (end == std::string_view::npos || !isWord(withoutBlanks(line.substr(0, end)))) continue;
    ++tagged;
    ++words[withoutBlanks(line.substr(0, end))];
  }
  return lines >= fewest && 10 * tagged >= 9 * lines && words.size() > 1;
}

std::vector<std::string> namesFrom(const TaggedCells& cells, size_t first) {
  std::vector<std::string> names;
  for (size_t k = first; k < cells.size(); ++k) names.emplace_back(cells[k]);
  return names;
}

/// Each table's names and how many rows fit them.
Tables tablesIn(std::string_view text, char lineEnd, char separator) {
  constexpr size_t mostTables = 500, formatsNames = 5;
  Tables tables;
  while (!text.empty()) {
    const TaggedCells cells = cellsOf(takeLine(text, lineEnd), separator);
    if (cells.size() < 3 || !isWord(cells[0])) continue;
    if (cells[0] == "FMT") {
      if (cells.size() > formatsNames && tables.size() < mostTables)
        tables[std::string(cells[3])].names = namesFrom(cells, formatsNames);
      continue;
    }
    auto it = tables.find(cells[0]);
    const bool words = std::none_of(cells.begin() + 1, cells.end(), isTaggedNumber);
    if (words && it == tables.end() && tables.size() < mostTables)
      tables[std::string(cells[0])].names = namesFrom(cells, 1);
    else if (!words && it != tables.end() && it->second.names.size() + 1 == cells.size())
      ++it->second.rows;
  }
  return tables;
}

/// How much of a motion the names tell: an angle most, then a speed, then what drives it; 0 without a motion.
int motionIn(const std::vector<std::string>& names) {
  int motion = 0, others = 0;
  for (const std::string& name : names) {
    const std::string to = understandName(name).to;
    if (to == "angle_rad" || to == "position_m") motion |= 8;
    if (to == "velocity_rad_per_s" || to == "velocity_m_per_s") motion |= 4;
    if (to == "current_A" || to == "voltage_V" || to == "torque_Nm" || to == "duty") others = 1;
    if (to == "time_s") others |= 2;
  }
  return motion == 0 ? 0 : motion + others;
}

}  // namespace

std::optional<TaggedRows> withTaggedRowsApart(std::string_view text) {
  const char lineEnd = lineEndOf(text);
  char separator = 0;
  for (const char one : {',', ';', '\t'}) {
    if (separator == 0 && areTagged(text, lineEnd, one)) separator = one;
  }
  if (separator == 0) return std::nullopt;
  const Tables tables = tablesIn(text, lineEnd, separator);
  constexpr size_t fewestRows = 2;
  size_t named = 0;
  const std::pair<const std::string, Tagged>* best = nullptr;
  int most = 0;
  for (const auto& table : tables) {
    if (table.second.rows < fewestRows) continue;
    ++named;
    const int motion = motionIn(table.second.names);
    if (motion > most || (best != nullptr && motion == most && motion > 0 && table.second.rows > best->second.rows)) {
      best = &table;
      most = motion;
    }
  }
  if (best == nullptr || named < 2) return std::nullopt;
  TaggedRows out;
  out.word = best->first;
  const auto append = [&out, separator](const auto& cells, size_t first) {
    for (size_t k = first; k < cells.size(); ++k)
      out.table += std::string(cells[k]) + (k + 1 < cells.size() ? separator : '\n');
  };
  append(best->second.names, 0);
  while (!text.empty()) {
    const std::string_view line = takeLine(text, lineEnd);
    if (withoutBlanks(line).empty()) continue;
    const TaggedCells cells = cellsOf(line, separator);
    const bool own = cells[0] == out.word && cells.size() == best->second.names.size() + 1;
    if (own && std::any_of(cells.begin() + 1, cells.end(), isTaggedNumber)) {
      append(cells, 1);
    } else {
      ++out.leftOut;
    }
  }
  return out;
}

}  // namespace breakaway
