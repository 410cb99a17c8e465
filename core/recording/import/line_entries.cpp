#include "recording/import/line_entries.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>
#include <vector>

#include "recording/import/column_name.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/sentence_parts.h"
#include "recording/import/text_layout.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

/// A kind of line: which of its values are columns of the table.
struct EntryKind {
  size_t count = 0;
  std::vector<std::pair<size_t, size_t>> columns;  ///< value, column
};
using Kinds = std::map<std::string, EntryKind>;

bool hasLetter(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80U; });
}

/// "[12.5] …" and "I (12345) …": what a logger puts before a line.
std::string_view stampName(const Sentence& line, size_t k) {
  if (isClock(line.values[k])) return "time";
  const std::string_view before = line.texts[k], behind = line.texts[k + 1];
  if (before.empty() || behind.empty()) return {};
  if (before.back() == '[' && behind.front() == ']') return "time";
  const bool level = k == 0 && before.size() == 3 && before.substr(1) == " (" && behind.front() == ')';
  return level && std::string_view("EWIDV").find(before.front()) != std::string_view::npos ? "time_ms"
                                                                                           : std::string_view{};
}

/// Separators before a value make cells of a row, quotes an object's names.
bool areCells(const Sentence& line) {
  for (size_t k = 0; k < line.values.size(); ++k) {
    const std::string_view text = line.texts[k];
    const size_t last = text.find_last_not_of(' ');
    if (last != std::string_view::npos && std::string_view(",;|\t").find(text[last]) != std::string_view::npos)
      return true;
    if (text.find_first_of("\"'") != std::string_view::npos) return true;
  }
  return false;
}

/// The names of a line's values, empty for those that aren't named; all are empty where one behind a named one isn't.
std::vector<std::string> namesIn(const Sentence& line) {
  std::vector<std::string> names(line.values.size());
  std::string_view unit;
  bool named = false, stamped = false;
  if (areCells(line)) return names;
  for (size_t k = 0; k < line.values.size(); ++k) {
    const std::string_view stamp = stampName(line, k);
    if (!stamp.empty()) {
      if (!stamped) names[k] = stamp;
      stamped = true;
      unit = {};
      continue;
    }
    std::string name = labelIn(line.texts[k], unit);
    if (!hasLetter(name)) {
      if (named) return std::vector<std::string>(line.values.size());
      unit = {};
      continue;
    }
    named = true;
    unit = unitIn(line.texts[k + 1]);
    if (!unit.empty()) name += " [" + std::string(unit) + "]";
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ';' || c == '"'; }, ' ');
    names[k] = std::move(name);
  }
  const bool stampAlone = stamped && names.size() == 1;
  return named || stampAlone ? names : std::vector<std::string>(line.values.size());
}

/// Kinds that return, of the first lines; empty where those aren't of a few kinds.
Kinds kindsIn(std::string_view text, char lineEnd) {
  constexpr size_t looksAt = 400, mostKinds = 40, fewest = 3;
  Kinds all;
  size_t lines = 0;
  while (!text.empty() && lines < looksAt) {
    const Sentence line = parted(takeLine(text, lineEnd));
    if (line.values.empty()) continue;
    ++lines;
    ++all[reading(line)].count;
  }
  size_t most = 0, covered = 0;
  for (const auto& [read, kind] : all) most = std::max(most, kind.count);
  std::erase_if(all, [&](const auto& one) { return one.second.count < std::max(fewest, most / 4); });
  for (const auto& [read, kind] : all) covered += kind.count;
  const bool few = all.size() > 1 && all.size() <= mostKinds && 2 * most <= lines + 1 && 3 * covered >= 2 * lines;
  return few ? all : Kinds{};
}

bool namesMotion(const std::string& name) {
  const std::string to = understandName(name).to;
  return to == "angle_rad" || to == "position_m" || to == "velocity_rad_per_s" || to == "velocity_m_per_s";
}

/// What all of them begin with is called by none of them: the logger's "Info quasarMotor" is nothing's name.
void dropCommonBeginning(std::vector<std::string>& columns) {
  constexpr size_t fewest = 3;
  const auto isNamed = [](const std::string& column) { return !column.starts_with("time"); };
  if (static_cast<size_t>(std::count_if(columns.begin(), columns.end(), isNamed)) < fewest) return;
  const auto first = std::find_if(columns.begin(), columns.end(), isNamed);
  size_t common = 0;
  for (size_t end = first->find(' '); end != std::string::npos; end = first->find(' ', end + 1)) {
    const std::string begin = first->substr(0, end + 1);
    const bool whose = isIn(jointWords, lowered(begin.substr(common, end - common)));  // "motor" is no logger's
    const bool all = std::all_of(columns.begin(), columns.end(), [&](const std::string& column) {
      return !isNamed(column) || (column.starts_with(begin) && column.size() > begin.size());
    });
    if (whose || !all) break;
    common = end + 1;
  }
  for (std::string& column : columns) {
    if (isNamed(column)) column.erase(0, common);
  }
}

/// Gives the kinds their columns, in the order in which they come; none where they name no motion, or one names
/// nothing.
std::vector<std::string> columnsOf(std::string_view text, char lineEnd, Kinds& kinds) {
  std::vector<std::string> columns;
  size_t seen = 0;
  std::map<std::string_view, bool> done;
  while (!text.empty() && seen < kinds.size()) {
    const Sentence line = parted(takeLine(text, lineEnd));
    const auto it = kinds.find(reading(line));
    if (it == kinds.end() || std::exchange(done[it->first], true)) continue;
    ++seen;
    const auto names = namesIn(line);
    for (size_t k = 0; k < names.size(); ++k) {
      if (names[k].empty() || std::find(columns.begin(), columns.end(), names[k]) != columns.end()) continue;
      it->second.columns.emplace_back(k, columns.size());
      columns.push_back(names[k]);
    }
  }
  size_t named = 0, nameless = 0;
  for (const auto& [read, kind] : kinds) (kind.columns.empty() ? nameless : named) += kind.count;
  std::erase_if(kinds, [](const auto& one) { return one.second.columns.empty(); });
  if (named <= nameless || kinds.size() < 2) return {};
  dropCommonBeginning(columns);
  return std::any_of(columns.begin(), columns.end(), namesMotion) ? columns : std::vector<std::string>{};
}

}  // namespace

std::optional<LineEntries> withEntriesAsRows(std::string_view text) {
  const char lineEnd = lineEndOf(text);
  Kinds kinds = kindsIn(text, lineEnd);
  if (kinds.empty()) return std::nullopt;
  const auto columns = columnsOf(text, lineEnd, kinds);
  if (columns.size() < 2) return std::nullopt;
  LineEntries out;
  out.lines = kinds.size();
  for (const std::string& column : columns) out.table += column + ";";
  out.table.back() = '\n';
  std::vector<std::string_view> cells(columns.size());
  std::map<std::string_view, bool> begun;
  const auto close = [&] {
    if (begun.empty()) return;
    for (std::string_view& cell : cells) {
      out.table += std::string(cell) + ";";
      cell = {};
    }
    out.table.back() = '\n';
    begun.clear();
  };
  while (!text.empty()) {
    const std::string_view raw = takeLine(text, lineEnd);
    const Sentence line = parted(raw);
    const auto kind = kinds.find(reading(line));
    if (kind == kinds.end()) {
      out.leftOut += line.values.empty() ? 0 : 1;
      continue;
    }
    if (begun.contains(kind->first)) close();
    begun[kind->first] = true;
    for (const auto& [value, column] : kind->second.columns) cells[column] = line.values[value];
  }
  close();
  return out;
}

}  // namespace breakaway
