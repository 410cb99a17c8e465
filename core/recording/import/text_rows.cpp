#include "recording/import/text_rows.h"

#include <algorithm>
#include <utility>

#include "recording/import/text_signals.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

/// LabVIEW repeats its head before each segment; with these words numbers follow, one per channel.
bool isHeadOfSegment(std::string_view cell) {
  return cell == "Samples" || cell == "X0" || cell == "Delta_X" || cell == "Channels";
}

}  // namespace

TextRows::TextRows(const TextLayout& layout, std::string name, size_t expected)
    : layout_(layout), name_(std::move(name)) {
  table.columns.resize(layout.cells);
  counts_.resize(layout.cells);
  numbers_.resize(layout.cells);
  kinds_.resize(layout.cells);
  texts_.resize(layout.cells);
  firstNumeric_ =
      static_cast<size_t>(std::find(layout.numeric.begin(), layout.numeric.end(), true) - layout.numeric.begin());
  for (RawColumn& column : table.columns) column.channel.values.reserve(expected);
}

LineKind TextRows::judge(std::string_view line) {
  splitCells(line, layout_, cells_);
  const size_t wanted = layout_.cells;
  while (cells_.size() > wanted && cells_.back().empty()) cells_.pop_back();
  if (cells_.size() != wanted) return judgeOther();
  size_t good = 0, bad = 0;
  for (size_t c = 0; c < wanted; ++c) {
    kinds_[c] = readCell(cells_[c], layout_, numbers_[c]);
    if (!layout_.numeric[c]) continue;
    good += kinds_[c] == TextCell::number || kinds_[c] == TextCell::clock ? 1 : 0;
    bad += kinds_[c] == TextCell::text ? 1 : 0;
  }
  if (isHeadOfSegment(cells_.front())) return LineKind::text;
  const bool begun =
      firstNumeric_ >= wanted || kinds_[firstNumeric_] != TextCell::text;  // else a label begins the line
  if (good == 0 || bad > good || !begun) return LineKind::text;
  return bad == 0 ? LineKind::row : LineKind::flawedRow;
}

void TextRows::append(bool flawed) {
  const size_t row = table.rows();
  if (flawed) flawed_.push_back(row);
  for (size_t c = 0; c < layout_.cells; ++c) {
    RawColumn& column = table.columns[c];
    const TextNumber& number = numbers_[c];
    if (row == 0 && number.large) column.origin = static_cast<double>(number.whole), origins_ = true;
    if (kinds_[c] == TextCell::clock) ++counts_[c].clocks;
    if (kinds_[c] == TextCell::number) ++counts_[c].numbers;
    if (kinds_[c] == TextCell::text) noteText(c, row);
    if (!number.unit.empty()) noteUnit(c, row);
    if (number.hexadecimal && !std::exchange(counts_[c].hexadecimal, true))
      table.remarks.push_back(
          message("{}: hexadecimal; eight digits are taken as 32 bits with a sign", column.channel.name));
    double value = number.value;
    if (origins_ && column.origin != 0.0) {
      const auto origin = static_cast<int64_t>(column.origin);
      value = number.large ? static_cast<double>(number.whole - origin) + number.rest : value - column.origin;
    }
    column.channel.values.push_back(value);
  }
}

std::string_view TextRows::sameTextOf(size_t c) const {
  const SeenText& seen = texts_[c];
  const bool same = seen.same && seen.count > 0 && seen.count + 1 >= table.rows();
  return same ? std::string_view(seen.first) : std::string_view{};
}

bool TextRows::labelsAlternate() const {
  if (layout_.cells < 4 || layout_.cells % 2 != 0) return false;
  for (size_t c = 0; c < layout_.cells; c += 2) {
    if (sameTextOf(c).empty() || !layout_.numeric[c + 1]) return false;
  }
  return true;
}

void TextRows::takeLabelColumns() {
  const bool alternate = labelsAlternate();
  for (size_t c = 0; c + 1 < layout_.cells; ++c) {
    std::string_view text = sameTextOf(c);
    const bool colon = text.size() > 1 && endsLabel(text), bare = alternate && c % 2 == 0 && !colon;
    if ((!colon && !bare) || !layout_.numeric[c + 1]) continue;
    if (colon) text.remove_suffix(1);
    std::string name(text);
    for (size_t k = c; k-- > 0;) {
      const std::string_view before = sameTextOf(k);
      if (before.empty() || endsLabel(before) || isUnit(before)) break;
      name = std::string(before) + " " + name;
    }
    std::string& own = table.columns[c + 1].channel.name;
    if (own.starts_with("column_")) own = name;
  }
}

void TextRows::takeUnitColumns() {
  if (labelsAlternate()) return;
  for (size_t c = 1; c < layout_.cells; ++c) {
    const SeenText& seen = texts_[c];
    const bool unit =
        seen.same && seen.count > 0 && seen.count + 1 >= table.rows() && isUnit(seen.first) && !endsLabel(seen.first);
    RawColumn& before = table.columns[c - 1];
    const std::string& name = table.columns[c].channel.name;
    const bool tellsUnit = name.starts_with("column_") || name.ends_with("unit") || name.ends_with("units") ||
                           name.ends_with("Unit") || name.ends_with("Units") || name.ends_with("Einheit");
    if (unit && before.unit.empty() && !before.fault && tellsUnit) before.unit = seen.first;
  }
}

template <typename Value>
void TextRows::dropRows(std::vector<Value>& values) const {
  size_t to = 0, next = 0;
  for (size_t k = 0; k < values.size(); ++k) {
    if (next < flawed_.size() && flawed_[next] == k) {
      ++next;
      continue;
    }
    values[to++] = values[k];
  }
  values.resize(to);
}

void TextRows::settle(size_t lastGoodRow) {
  while (!flawed_.empty() && flawed_.back() > lastGoodRow) flawed_.pop_back();
  for (RawColumn& column : table.columns) {
    column.channel.values.resize(lastGoodRow + 1);
    if (!column.texts.empty()) column.textOf.resize(lastGoodRow + 1);
  }
  if (100 * flawed_.size() <= table.rows() && !flawed_.empty()) {
    table.remarks.push_back(
        flawed_.size() == 1
            ? message("1 row with text among its numbers was left out, the first is row {}", flawed_.front() + 1)
            : message("{} rows with text among their numbers were left out, the first is row {}", flawed_.size(),
                      flawed_.front() + 1));
    for (RawColumn& column : table.columns) {
      dropRows(column.channel.values);
      if (!column.texts.empty()) dropRows(column.textOf);
    }
    for (size_t c = 0; c < layout_.cells; ++c) {
      if (layout_.numeric[c]) table.columns[c].fault.reset();
    }
  } else if (flawed_.empty()) {
    for (size_t c = 0; c < layout_.cells; ++c) {
      if (layout_.numeric[c]) table.columns[c].fault.reset();  // those were in rows that are no part of the table
    }
  }
  for (size_t c = 0; c < layout_.cells; ++c) settleClock(c);
}

LineKind TextRows::judgeOther() {
  size_t numbers = 0, filled = 0;
  TextNumber number;
  for (size_t c = 0; c < cells_.size() && c < mostCellsOfARow; ++c) {
    const TextCell kind = readCell(cells_[c], layout_, number);
    numbers += kind == TextCell::number || kind == TextCell::clock ? 1 : 0;
    filled += cells_[c].empty() ? 0 : 1;
  }
  return numbers >= 2 && 2 * numbers > filled ? LineKind::otherRow : LineKind::text;
}

void TextRows::noteText(size_t c, size_t row) {
  RawColumn& column = table.columns[c];
  SeenText& seen = texts_[c];
  if (seen.count++ == 0) seen.first = cells_[c].substr(0, 40);
  seen.same = seen.same && cells_[c] == seen.first;
  rememberText(column, row, cells_[c]);
  if (column.fault) return;
  column.fault = Error{name_ + ", row " + std::to_string(row + 1) + ", column " + column.channel.name,
                       message("expected a number, found \"{}\"", cells_[c].substr(0, 40))};
}

void TextRows::noteUnit(size_t c, size_t row) {
  RawColumn& column = table.columns[c];
  const std::string_view unit = numbers_[c].unit;
  if (column.unit.empty()) column.unit = unit;
  if (column.unit == unit || column.fault || unitNamed(column.unit) == unitNamed(unit)) return;
  column.fault = Error{name_ + ", row " + std::to_string(row + 1) + ", column " + column.channel.name,
                       message("is in {}, others in {}", unit, column.unit)};
}

void TextRows::settleClock(size_t c) {
  RawColumn& column = table.columns[c];
  if (counts_[c].clocks == 0) return;
  column.clock = counts_[c].numbers == 0;
  if (!column.clock && !column.fault) {
    column.fault = Error{name_ + ", column " + column.channel.name, message("holds times of day beside numbers")};
  }
}

}  // namespace breakaway
