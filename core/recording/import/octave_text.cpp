#include "recording/import/octave_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "recording/import/npy.h"
#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

constexpr size_t mostColumns = 5000;
constexpr size_t mostOfRanges = 10000000;  ///< values of all ranges: a line makes as many as it likes

/// What stands behind "# key: "; empty when the line is of another key.
std::string_view valueOf(std::string_view line, std::string_view key) {
  if (line.empty() || line.front() != '#') return {};
  line = withoutBlanks(line.substr(1));
  if (!line.starts_with(key)) return {};
  line = withoutBlanks(line.substr(key.size()));
  return line.starts_with(':') ? withoutBlanks(line.substr(1)) : std::string_view{};
}

std::vector<double> lineNumbers(std::string_view line) {
  TextLayout layout;
  layout.separator = runsOfBlanks;
  std::vector<std::string_view> cells;
  splitCells(line, layout, cells);
  std::vector<double> numbers;
  for (const std::string_view cell : cells) {
    TextNumber number;
    if (readCell(cell, layout, number) == TextCell::text) return {};
    numbers.push_back(number.value);
  }
  return numbers;
}

/// A variable that is being read.
struct Variable {
  std::string name, type;
  std::vector<RawColumn> columns;
  size_t room = mostOfRanges;  ///< left for values of ranges
};

/// Base, limit and increment, as "t = 0:0.01:2" is kept.
Result<void> addRange(const std::vector<double>& range, Variable& variable, const std::string& place) {
  if (range.size() < 3) return {};
  const double steps = (range[1] - range[0]) / range[2];
  if (!(steps >= 0.0) || steps >= static_cast<double>(variable.room))
    return Error{place, message("the range {} has more values than a log", variable.name)};
  const auto count = static_cast<size_t>(std::floor(steps * (1.0 + 1e-12) + 1e-9)) + 1;
  variable.room -= std::min(variable.room, count);
  RawColumn column{{variable.name, {}}, {}};
  for (size_t k = 0; k < count; ++k) column.channel.values.push_back(range[0] + static_cast<double>(k) * range[2]);
  variable.columns.push_back(std::move(column));
  return {};
}

Result<void> addRow(std::string_view line, Variable& variable, const std::string& place) {
  const bool range = variable.type.ends_with("range"), scalar = variable.type == "scalar";
  if (!range && !scalar && variable.type != "matrix") return {};
  const std::vector<double> row = lineNumbers(line);
  if (row.empty()) return {};
  if (range) return variable.columns.empty() ? addRange(row, variable, place) : Result<void>{};
  if (row.size() > mostColumns) return Error{place, message("{} has too many columns", variable.name)};
  if (variable.columns.empty()) {
    for (size_t c = 0; c < row.size(); ++c) {
      const std::string index = row.size() == 1 ? "" : "(:," + std::to_string(c + 1) + ")";
      variable.columns.push_back({{variable.name + index, {}}, {}});
    }
  }
  if (row.size() != variable.columns.size())
    return Error{place, message("the rows of {} differ in length", variable.name)};
  for (size_t c = 0; c < row.size(); ++c) variable.columns[c].channel.values.push_back(row[c]);
  return {};
}

/// One row of many values is a signal as well.
void finish(Variable& variable, std::vector<RawColumn>& columns) {
  const bool oneRow = variable.columns.size() > 1 && variable.columns.front().channel.values.size() == 1;
  if (oneRow) {
    RawColumn column{{variable.name, {}}, {}};
    for (const RawColumn& one : variable.columns) column.channel.values.push_back(one.channel.values.front());
    variable.columns = {std::move(column)};
  }
  for (RawColumn& column : variable.columns) {
    if (columns.size() < mostColumns) columns.push_back(std::move(column));
  }
}

}  // namespace

std::optional<Result<RawTable>> readOctaveText(std::string_view text, char lineEnd, const std::string& name) {
  constexpr size_t linesOfHead = 3;
  std::string_view rest = text;
  bool begins = false;
  for (size_t k = 0; k < linesOfHead && !begins && !rest.empty(); ++k) {
    const bool named = !valueOf(withoutBlanks(takeLine(rest, lineEnd)), "name").empty();
    std::string_view next = rest;
    begins = named && !valueOf(withoutBlanks(takeLine(next, lineEnd)), "type").empty();
  }
  if (!begins) return std::nullopt;
  std::vector<RawColumn> columns;
  Variable variable;
  rest = text;
  while (!rest.empty()) {
    const std::string_view line = withoutBlanks(takeLine(rest, lineEnd));
    if (const auto named = valueOf(line, "name"); !named.empty()) {
      finish(variable, columns);
      variable = {std::string(named), {}, {}, variable.room};
    } else if (const auto type = valueOf(line, "type"); !type.empty()) {
      variable.type = std::string(type);
    } else if (!line.empty() && line.front() != '#') {
      if (const auto added = addRow(line, variable, name); !added) return added.error();
    }
  }
  finish(variable, columns);
  if (columns.empty()) return Error{name, message("holds Octave's variables, none of them a matrix of numbers")};
  return tableOfColumns(std::move(columns), name);
}

}  // namespace breakaway
