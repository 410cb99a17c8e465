#include "recording/import/text_names.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "recording/import/column_name.h"
#include "recording/import/name_parts.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

using Cells = std::vector<std::string_view>;

std::string_view withoutCommentMark(std::string_view line) {
  line = withoutBlanks(line);
  const size_t start = line.find_first_not_of("#%/ \t");
  if (start == std::string_view::npos) return {};
  line.remove_prefix(start);
  for (const std::string_view label : {"columns:", "fields:", "names:", "header:"}) {  // "# columns: t q dq"
    if (line.size() > label.size() && isSameWord(line.substr(0, label.size()), label))
      return withoutBlanks(line.substr(label.size()));
  }
  return line;
}

bool isNumberIn(std::string_view cell, const TextLayout& layout) {
  TextNumber number;
  return readCell(cell, layout, number) == TextCell::number;
}

size_t numbersIn(const Cells& cells, const TextLayout& layout) {
  return static_cast<size_t>(
      std::count_if(cells.begin(), cells.end(), [&](std::string_view cell) { return isNumberIn(cell, layout); }));
}

/// Cells parted by two blanks or more: names with single blanks in them.
Cells splitAtWideBlanks(std::string_view line) {
  Cells cells;
  line = withoutBlanks(line);
  while (!line.empty()) {
    const size_t end = std::min(line.find("  "), line.find('\t'));
    cells.push_back(withoutBlanks(line.substr(0, end)));
    line = end == std::string_view::npos ? std::string_view{} : withoutBlanks(line.substr(end));
  }
  return cells;
}

/// One name fewer than cells: the rows end in a separator, or begin with their number as R writes them.
bool fillUp(Cells& cells, const TextLayout& layout, bool endsEmpty) {
  const bool names = cells.size() + 1 == layout.cells && cells.size() > 1 && numbersIn(cells, layout) == 0 &&
                     std::any_of(cells.begin(), cells.end(), [](std::string_view cell) { return knowsQuantity(cell); });
  if (!names) return false;
  cells.insert(endsEmpty ? cells.end() : cells.begin(), std::string_view{});
  return true;
}

/// Names for the first of many cells, the rest without: rows that go on where the names end.
bool fillRest(Cells& cells, const TextLayout& layout) {
  constexpr size_t fewest = 4;
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  const bool many = cells.size() >= fewest && cells.size() + 1 < layout.cells && 3 * cells.size() >= 2 * layout.cells;
  if (!many || numbersIn(cells, layout) > 0) return false;
  const auto known = std::count_if(cells.begin(), cells.end(), [](std::string_view one) { return knowsQuantity(one); });
  if (known < 2) return false;
  cells.resize(layout.cells);
  return true;
}

/// Where the rows hold nothing: before their first separator, after their last.
struct EmptyEnds {
  bool begin = false, end = false;
};

/// "Total samples: 3000, Time: 30000 ms": a sentence that tells values, no names.
bool tellsValues(std::string_view line) {
  for (size_t at = line.find(": "); at != std::string_view::npos; at = line.find(": ", at + 2)) {
    const size_t value = line.find_first_not_of(' ', at + 2);
    if (value != std::string_view::npos && std::isdigit(static_cast<unsigned char>(line[value])) != 0) return true;
  }
  return false;
}

/// "COLS" of "COLS,t,rpm", "FORMAT" of "FORMAT,DATA,time_ms": a word that says that names follow.
bool saysThatNamesFollow(std::string_view cell) {
  static constexpr std::string_view words[] = {"columns", "cols", "fields", "names", "header", "head", "format"};
  return std::any_of(std::begin(words), std::end(words),
                     [cell](std::string_view word) { return isSameWord(cell, word); });
}

/// The line's cells if they are as many as a row's, a few empty ones at the end aside.
Cells fitting(std::string_view line, const TextLayout& layout, const EmptyEnds& rows) {
  Cells cells;
  const size_t wanted = layout.cells;
  const auto fits = [&] {
    while (cells.size() > wanted && cells.back().empty()) cells.pop_back();
    return cells.size() == wanted;
  };
  splitCells(line, layout, cells);
  if (fits() || fillUp(cells, layout, rows.end)) return cells;
  if (cells.size() == wanted + 1 && saysThatNamesFollow(withoutBlanks(cells.front()))) {
    cells.erase(cells.begin());
    return cells;
  }
  if (cells.size() > wanted && isSameWord(cells.back(), "comment")) {  // LabVIEW's last column
    cells.pop_back();
    // Its first one is empty where the times aren't written out; blanks as separators don't count it.
    if (cells.size() == wanted + 1 && rows.begin) cells.erase(cells.begin());
    if (cells.size() == wanted) return cells;
  }
  TextLayout other = layout;
  for (const char separator : {'\t', ';', ',', '|'}) {
    other.separator = separator;
    splitCells(line, other, cells);
    if (fits()) return cells;
  }
  cells = splitAtWideBlanks(line);
  if (fits()) return cells;
  if (layout.separator == runsOfBlanks) return {};
  splitCells(line, layout, cells);
  return fillRest(cells, layout) ? cells : Cells{};
}

/// "rad" of "Unit: rad".
std::string_view withoutUnitWord(std::string_view cell) {
  const size_t colon = cell.find(':');
  if (colon == std::string_view::npos ||
      (!isSameWord(cell.substr(0, colon), "unit") && !isSameWord(cell.substr(0, colon), "units")))
    return cell;
  return withoutBlanks(cell.substr(colon + 1));
}

bool isUnitCell(std::string_view cell) {
  cell = withoutUnitWord(cell);
  return isUnit(cell) || !unitBeforeQuantity(cell).empty() ||
         (cell.size() > 2 && (cell.front() == '(' || cell.front() == '[') &&
          (cell.back() == ')' || cell.back() == ']'));
}

size_t countOf(const Cells& cells, bool (*is)(std::string_view)) {
  return static_cast<size_t>(std::count_if(cells.begin(), cells.end(), is));
}

bool knownName(std::string_view cell) {
  return knowsQuantity(cell);
}

std::string_view withoutBrackets(std::string_view cell) {
  if (cell.size() >= 2 && (cell.front() == '(' || cell.front() == '[')) return cell.substr(1, cell.size() - 2);
  return cell;
}

/// Groups above the names: each group's word stands over its first column. What begins with a mark is a line between
/// parts of the file.
void putGroupsBefore(const Cells& groups, std::vector<std::string>& names) {
  std::string_view group;
  for (size_t c = 0; c < names.size(); ++c) {
    const bool word = !groups[c].empty() && std::strchr("*-=#+~", groups[c].front()) == nullptr;
    if (word) group = groups[c];
    if (!group.empty() && group != names[c]) names[c] = std::string(group) + " " + names[c];
  }
}

void fill(const Cells& cells, TextNames& found) {
  for (size_t c = 0; c < found.names.size(); ++c) {
    if (!cells[c].empty()) found.names[c] = std::string(cells[c]);
  }
  found.found = true;
}

/// A name that stands there twice gets a number.
void makeUnique(std::vector<std::string>& names) {
  std::map<std::string, int> seen;
  for (std::string& name : names) {
    const int count = ++seen[name];
    if (count > 1) name += " (" + std::to_string(count) + ")";
  }
}

void readLabels(std::string_view row, const TextLayout& layout, TextNames& found) {
  Cells cells;
  splitCells(row, layout, cells);
  for (size_t c = 0; c < cells.size() && c < found.names.size(); ++c) {
    if (const auto label = labelOf(cells[c]); !label.empty()) found.names[c] = std::string(label);
    found.units[c] = std::string(unitBehind(cells[c]));
  }
  found.found = true;
}

/// Units of which some are numbers: "s,1,mm,N".
bool areUnitsWithOnes(const Cells& cells, const TextLayout& layout) {
  size_t units = 0;
  for (const std::string_view cell : cells) {
    if (isNumberIn(cell, layout) && cell != "1") return false;
    units += cell != "1" && isUnitCell(cell) ? 1 : 0;
  }
  return units > 1;
}

/// A line of nothing but units, above one that names at most one thing by a unit.
bool unitsStandAbove(const Cells& above, const Cells& names) {
  constexpr size_t fewest = 3;
  const auto filled = above.size() - static_cast<size_t>(std::count(above.begin(), above.end(), std::string_view{}));
  return filled >= fewest && countOf(above, isUnitCell) == filled && countOf(names, isUnitCell) <= 1;
}

/// "X,Y,X,Y": each signal has a column of times and one of values.
bool arePairs(const Cells& cells) {
  if (cells.size() < 2 || cells.size() % 2 != 0) return false;
  for (size_t c = 0; c < cells.size(); c += 2) {
    if (!isSameWord(cells[c], "x") || !isSameWord(cells[c + 1], "y")) return false;
  }
  return true;
}

/// Each signal's name stands over its times.
bool fillPairs(const Cells& above, TextNames& found) {
  for (size_t c = 0; c < above.size(); c += 2) {
    if (above[c].empty() || !above[c + 1].empty()) return false;
  }
  for (size_t c = 0; c < above.size(); c += 2) {
    found.names[c] = "time";
    found.names[c + 1] = std::string(above[c]);
  }
  found.found = true;
  return true;
}

/// Names and units from the last lines that are no comments.
void readLines(std::vector<std::string_view> lines, const TextLayout& layout, const EmptyEnds& rows, TextNames& found) {
  if (lines.size() > 1 && tellsValues(lines.back()) && !fitting(lines[lines.size() - 2], layout, rows).empty())
    lines.pop_back();
  const Cells last = lines.empty() ? Cells{} : fitting(lines.back(), layout, rows);
  if (last.empty()) {
    // Events and greetings may stand between the names and the rows.
    for (size_t k = lines.size(); k-- > 0;) {
      const Cells earlier = fitting(lines[k], layout, rows);
      if (earlier.empty() || numbersIn(earlier, layout) > 0 || countOf(earlier, knownName) < 2) continue;
      fill(earlier, found);
      return;
    }
    return;
  }
  const Cells above = lines.size() < 2 ? Cells{} : fitting(lines[lines.size() - 2], layout, rows);
  if (!above.empty() && arePairs(last) && fillPairs(above, found)) return;
  const size_t numbers = numbersIn(last, layout);
  const bool aboveIsText = !above.empty() && numbersIn(above, layout) == 0;
  const size_t units = countOf(last, isUnitCell), names = countOf(last, knownName);
  const bool withOnes = aboveIsText && countOf(above, knownName) > 1 && areUnitsWithOnes(last, layout);
  if (numbers > 0 && !withOnes) {
    // Channels by number with no line of units; else what stands there is a row of other values.
    if (2 * numbers <= last.size() && names > 0) {
      fill(last, found);
    } else if (aboveIsText && countOf(above, knownName) > 1) {
      fill(above, found);  // the first row is spoilt, as by "#VALUE!"
    }
    return;
  }
  const auto filled = last.size() - static_cast<size_t>(std::count(last.begin(), last.end(), std::string_view{}));
  // ",Interp: linear,Interp: linear": how signals are drawn.
  const auto first = std::find_if(last.begin(), last.end(), [](std::string_view cell) { return !cell.empty(); });
  const bool property = units == 0 && filled > 1 && !above.empty() && aboveIsText &&
                        first->find(':') != std::string_view::npos &&
                        filled == static_cast<size_t>(std::count(last.begin(), last.end(), *first));
  if (property) {
    fill(above, found);
    return;
  }
  if (unitsStandAbove(above, last)) {
    fill(last, found);
    for (size_t c = 0; c < above.size(); ++c) found.units[c] = std::string(withoutBrackets(withoutUnitWord(above[c])));
    return;
  }
  const bool areUnits = !above.empty() && (withOnes || units > names || units == filled || (aboveIsText && names == 0));
  if (areUnits) {
    fill(above, found);
    for (size_t c = 0; c < last.size(); ++c) found.units[c] = std::string(withoutBrackets(withoutUnitWord(last[c])));
    const Cells third = lines.size() < 3 ? Cells{} : fitting(lines[lines.size() - 3], layout, rows);
    const bool groups = !third.empty() && numbersIn(third, layout) == 0 && countOf(above, knownName) > 0 &&
                        countOf(third, knownName) == 0;
    if (groups) putGroupsBefore(third, found.names);
    return;
  }
  fill(last, found);
  if (aboveIsText && countOf(above, knownName) < names) putGroupsBefore(above, found.names);
}

/// "0 = Target" of "NAME0 = Target", "2: torque" of "Column 2: torque".
std::string_view withoutColumnWord(std::string_view text) {
  for (const std::string_view word : {"name", "column", "col", "channel", "field", "signal", "spalte"}) {
    if (text.size() <= word.size() || !isSameWord(text.substr(0, word.size()), word)) continue;
    const std::string_view rest = withoutBlanks(text.substr(word.size()));
    const size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    const std::string_view mark = withoutBlanks(rest.substr(digits));
    if (digits > 0 && !mark.empty() && (mark.front() == '=' || mark.front() == ':')) return rest;
  }
  return text;
}

/// "12" and "left motor's current" of "% 12 left motor's current"; nothing where no number begins the line.
std::optional<std::pair<size_t, std::string_view>> numberedName(std::string_view line) {
  constexpr size_t mostDigits = 3;
  const std::string_view text = withoutColumnWord(withoutCommentMark(line));
  const size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const size_t begin = std::min(text.find_first_not_of(" \t:.)=-", digits), text.size());
  if (digits == 0 || digits > mostDigits || begin == digits || begin == text.size()) return std::nullopt;
  if (std::isalpha(static_cast<unsigned char>(text[begin])) == 0) return std::nullopt;
  return std::pair{static_cast<size_t>(std::stoul(std::string(text.substr(0, digits)))),
                   withoutBlanks(text.substr(begin))};
}

/// "1 time stamp (sec)", below it "2 motor voltage": the columns' names by their numbers, from 0 or 1 on; as many as
/// there are columns.
void readNumberedNames(const std::vector<std::string_view>& lines, TextNames& found) {
  std::vector<std::string_view> names;
  size_t from = 0;
  for (const std::string_view line : lines) {
    const auto one = numberedName(line);
    if (one && names.empty() && one->first <= 1) from = one->first;
    if (!one || one->first != from + names.size()) {
      if (names.size() == found.names.size()) break;
      names.clear();
      from = 0;
      continue;
    }
    names.push_back(one->second);
  }
  if (names.size() != found.names.size() || names.size() < 2) return;
  for (size_t c = 0; c < names.size(); ++c) found.names[c] = std::string(names[c]);
  found.found = true;
}

}  // namespace

bool isNamesLine(std::string_view line, const TextLayout& layout) {
  Cells cells;
  splitCells(line, layout, cells);
  if (cells.size() == layout.cells + 1 && isSameWord(cells.back(), "comment")) cells.pop_back();
  if (cells.size() != layout.cells || numbersIn(cells, layout) > 0) return false;
  const auto empty = std::count(cells.begin(), cells.end(), std::string_view{});
  return 2 * static_cast<size_t>(empty) < cells.size() && countOf(cells, knownName) > 0;
}

TextNames namesBefore(const std::vector<std::string_view>& before, std::string_view firstRow,
                      const TextLayout& layout) {
  TextNames found{std::vector<std::string>(layout.cells), std::vector<std::string>(layout.cells), false};
  for (size_t c = 0; c < layout.cells; ++c) found.names[c] = "column_" + std::to_string(c + 1);
  if (layout.labelled) {
    readLabels(firstRow, layout, found);
    makeUnique(found.names);
    return found;
  }
  std::vector<std::string_view> plain, comments;
  for (const std::string_view line : before) {
    if (line.find_first_not_of("-|=+: \t_~\r") == std::string_view::npos) continue;  // a rule, as in Markdown
    if (isComment(withoutBlanks(line))) {
      comments.push_back(withoutCommentMark(line));
    } else {
      plain.push_back(line);
    }
  }
  Cells row;
  splitCells(firstRow, layout, row);
  const EmptyEnds rows{!firstRow.empty() && (firstRow.front() == '\t' || firstRow.front() == layout.separator),
                       !row.empty() && row.back().empty()};
  readNumberedNames(before, found);
  if (!found.found) readLines(plain, layout, rows, found);
  if (!found.found && !before.empty() && isComment(withoutBlanks(before.back())))
    readLines(comments, layout, rows, found);
  makeUnique(found.names);
  return found;
}

}  // namespace breakaway
