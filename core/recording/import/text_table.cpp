#include "recording/import/text_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recording/import/codesys_trace.h"
#include "recording/import/controldesk.h"
#include "recording/import/line_entries.h"
#include "recording/import/list_cells.h"
#include "recording/import/named_lists.h"
#include "recording/import/octave_text.h"
#include "recording/import/sentence_rows.h"
#include "recording/import/stamped_lines.h"
#include "recording/import/tagged_rows.h"
#include "recording/import/text_encoding.h"
#include "recording/import/text_layout.h"
#include "recording/import/text_names.h"
#include "recording/import/text_signals.h"
#include "recording/import/units.h"
#include "recording/import/yaml_messages.h"

namespace breakaway {

namespace {

constexpr size_t mostCells = 10000;
constexpr size_t mostPreamble = 200;

/// Lines that stand for all: everything in a short text, five parts of a long one.
std::vector<std::string_view> sampleOf(std::string_view text, char lineEnd) {
  constexpr size_t shortText = 400000, partSize = 16000;
  std::vector<std::string_view> lines;
  const auto take = [&](std::string_view part, size_t most) {
    while (!part.empty() && most > 0) {
      const std::string_view line = takeLine(part, lineEnd);
      const std::string_view trimmed = withoutBlanks(line);
      if (trimmed.empty() || isComment(trimmed)) continue;
      lines.push_back(line);
      --most;
    }
  };
  if (text.size() <= shortText) {
    take(text, 1000);
    if (lines.size() < 1000) {
      if (lines.size() > 3) lines.pop_back();  // may be cut short
      return lines;
    }
    lines.clear();
  }
  for (const double place : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    std::string_view part = text.substr(static_cast<size_t>(place * static_cast<double>(text.size())));
    takeLine(part, lineEnd);
    take(part.substr(0, partSize), 100);
  }
  return lines;
}

/// What a line is to the table.
enum class LineKind {
  row,
  flawedRow,  ///< text stands where numbers belong
  otherRow,   ///< numbers, but not as many cells
  text
};

/// LabVIEW repeats its head before each segment; with these words numbers follow, one per channel.
bool isHeadOfSegment(std::string_view cell) {
  return cell == "Samples" || cell == "X0" || cell == "Delta_X" || cell == "Channels";
}

/// Reads one table after the other line by line.
class Rows {
 public:
  Rows(const TextLayout& layout, std::string name, size_t expected) : layout_(layout), name_(std::move(name)) {
    table.columns.resize(layout.cells);
    counts_.resize(layout.cells);
    numbers_.resize(layout.cells);
    kinds_.resize(layout.cells);
    texts_.resize(layout.cells);
    firstNumeric_ =
        static_cast<size_t>(std::find(layout.numeric.begin(), layout.numeric.end(), true) - layout.numeric.begin());
    for (RawColumn& column : table.columns) column.channel.values.reserve(expected);
  }

  RawTable table;

  LineKind judge(std::string_view line) {
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

  /// Takes the line that was judged last.
  void append(bool flawed) {
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

  /// "RPM:" in each row, before a number, is its name, with the words before it: "Angular Velocity: 1.5".
  void takeLabelColumns() {
    const auto label = [this](size_t c) {
      const SeenText& seen = texts_[c];
      const bool same = seen.same && seen.count > 0 && seen.count + 1 >= table.rows();
      return same ? std::string_view(seen.first) : std::string_view{};
    };
    for (size_t c = 0; c + 1 < layout_.cells; ++c) {
      std::string_view text = label(c);
      if (text.size() < 2 || !endsLabel(text) || !layout_.numeric[c + 1]) continue;
      text.remove_suffix(1);
      std::string name(text);
      for (size_t k = c; k-- > 0;) {
        const std::string_view before = label(k);
        if (before.empty() || endsLabel(before) || isUnit(before)) break;
        name = std::string(before) + " " + name;
      }
      std::string& own = table.columns[c + 1].channel.name;
      if (own.starts_with("column_")) own = name;
    }
  }

  static bool endsLabel(std::string_view text) { return text.back() == ':' || text.back() == '='; }

  /// A column without a name, or called a unit, that holds the same unit in each row tells the one of the column before
  /// it: "12.3 deg".
  void takeUnitColumns() {
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

  size_t cellsOfLast() const { return cells_.size(); }

  /// Leaves out the flawed rows after the last good one, and all of them when they are few.
  void settle(size_t lastGoodRow) {
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

 private:
  struct Counts {
    size_t clocks = 0, numbers = 0;
    bool hexadecimal = false;
  };
  struct SeenText {
    size_t count = 0;
    std::string first;
    bool same = true;
  };

  LineKind judgeOther() {
    size_t numbers = 0, filled = 0;
    TextNumber number;
    for (size_t c = 0; c < cells_.size() && c < mostCells; ++c) {
      const TextCell kind = readCell(cells_[c], layout_, number);
      numbers += kind == TextCell::number || kind == TextCell::clock ? 1 : 0;
      filled += cells_[c].empty() ? 0 : 1;
    }
    return numbers >= 2 && 2 * numbers > filled ? LineKind::otherRow : LineKind::text;
  }

  void noteText(size_t c, size_t row) {
    RawColumn& column = table.columns[c];
    SeenText& seen = texts_[c];
    if (seen.count++ == 0) seen.first = cells_[c].substr(0, 40);
    seen.same = seen.same && cells_[c] == seen.first;
    rememberText(column, row, cells_[c]);
    if (column.fault) return;
    column.fault = Error{name_ + ", row " + std::to_string(row + 1) + ", column " + column.channel.name,
                         message("expected a number, found \"{}\"", cells_[c].substr(0, 40))};
  }

  /// All cells of a column have one unit.
  void noteUnit(size_t c, size_t row) {
    RawColumn& column = table.columns[c];
    const std::string_view unit = numbers_[c].unit;
    if (column.unit.empty()) column.unit = unit;
    if (column.unit == unit || column.fault || unitNamed(column.unit) == unitNamed(unit)) return;
    column.fault = Error{name_ + ", row " + std::to_string(row + 1) + ", column " + column.channel.name,
                         message("is in {}, others in {}", unit, column.unit)};
  }

  template <typename Value>
  void dropRows(std::vector<Value>& values) const {
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

  void settleClock(size_t c) {
    RawColumn& column = table.columns[c];
    if (counts_[c].clocks == 0) return;
    column.clock = counts_[c].numbers == 0;
    if (!column.clock && !column.fault) {
      column.fault = Error{name_ + ", column " + column.channel.name, message("holds times of day beside numbers")};
    }
  }

  const TextLayout& layout_;
  std::string name_;
  std::vector<std::string_view> cells_;
  std::vector<TextNumber> numbers_;
  std::vector<TextCell> kinds_;
  std::vector<Counts> counts_;
  std::vector<SeenText> texts_;
  std::vector<size_t> flawed_;
  size_t firstNumeric_ = 0;
  bool origins_ = false;
};

void addNote(std::string_view line, RawTable& table) {
  const size_t colon = line.find(':');
  if (colon == std::string_view::npos || table.notes.size() >= mostPreamble) return;
  const std::string_view key = withoutBlanks(line.substr(0, colon));
  const size_t start = key.find_first_not_of("#%/ \t");
  if (start != std::string_view::npos)
    table.notes.emplace_back(key.substr(start), withoutBlanks(line.substr(colon + 1)));
}

/// Where the first row stands: rows follow it, and no names do.
struct Start {
  std::string_view rest;                 ///< from the first row on
  std::vector<std::string_view> before;  ///< lines before it, the last ones
  bool found = false;
};

Start findStart(std::string_view text, char lineEnd, const TextLayout& layout, Rows& rows, RawTable& notes) {
  constexpr size_t looksAhead = 5;
  Start start;
  while (!text.empty()) {
    const std::string_view from = text;
    const std::string_view line = takeLine(text, lineEnd);
    const std::string_view trimmed = withoutBlanks(line);
    if (trimmed.empty()) continue;
    const bool comment = isComment(trimmed);
    if (comment) addNote(trimmed, notes);
    if (!comment && rows.judge(line) == LineKind::row) {
      std::string_view ahead = text;
      size_t all = 0, good = 0;
      bool names = false;
      while (!ahead.empty() && all < looksAhead) {
        const std::string_view next = takeLine(ahead, lineEnd);
        const std::string_view trimmedNext = withoutBlanks(next);
        if (trimmedNext.empty() || isComment(trimmedNext)) continue;
        ++all;
        const LineKind kind = rows.judge(next);
        good += kind == LineKind::row || kind == LineKind::flawedRow ? 1 : 0;
        names = names || (kind == LineKind::text && isNamesLine(next, layout));
      }
      if (2 * good >= all && !names) {
        start.rest = from;
        start.found = true;
        return start;
      }
    }
    start.before.push_back(line);
    if (start.before.size() > mostPreamble) start.before.erase(start.before.begin() + 20);
  }
  return start;
}

Message inFewWords(size_t count, std::string_view first) {
  std::string shown(first.substr(0, 40));
  if (first.size() > 40) shown = shown.substr(0, shown.find_last_of(' ')) + " …";
  while (!isUtf8(shown)) shown.pop_back();
  return count == 1 ? message("1 line between or after the rows is no row and was left out, the first: \"{}\"", shown)
                    : message("{} lines between or after the rows are no rows and were left out, the first: \"{}\"",
                              count, shown);
}

/// A line of names other than the table's, and that didn't stand above it: a further table begins.
bool beginsFurtherTable(std::string_view line, const TextLayout& layout, const TextNames& names,
                        const std::vector<std::string_view>& before) {
  if (!names.found || layout.labelled || !isNamesLine(line, layout)) return false;
  if (std::find(before.begin(), before.end(), line) != before.end()) return false;
  std::vector<std::string_view> cells;
  splitCells(line, layout, cells);
  size_t other = 0;
  for (const std::string_view cell : cells)
    other += std::find(names.names.begin(), names.names.end(), cell) == names.names.end() ? 1 : 0;
  return other > 0 && 2 * other >= cells.size();
}

Result<void> readRows(std::string_view rest, char lineEnd, const TextLayout& layout, const TextNames& names,
                      const std::vector<std::string_view>& before, const std::string& name, Rows& rows) {
  size_t others = 0, texts = 0, otherAt = 0, otherCells = 0, lastGood = 0;
  std::string_view firstText;
  bool cut = false;
  size_t further = 0;   // rows of a table below that has other cells
  bool parted = false;  // a line that is no row stands before
  const char* textEnd = rest.data() + rest.size();
  while (!rest.empty()) {
    const std::string_view line = takeLine(rest, lineEnd);
    const bool lastWithoutEnd = line.data() + line.size() == textEnd;
    const std::string_view trimmed = withoutBlanks(line);
    const bool comment = isComment(trimmed);
    if (comment) addNote(trimmed, rows.table);
    if (comment || trimmed.empty()) {
      parted = true;
      continue;
    }
    const LineKind kind = rows.judge(line);
    if (kind == LineKind::row || kind == LineKind::flawedRow) {
      further = 0;
      parted = false;
      rows.append(kind == LineKind::flawedRow);
      if (kind == LineKind::row) lastGood = rows.table.rows() - 1;
    } else if (kind == LineKind::text && rows.table.rows() > 1 && beginsFurtherTable(line, layout, names, before)) {
      rows.table.remarks.push_back(
          message("a table with other names begins below row {} and was left out", rows.table.rows()));
      break;
    } else if (lastWithoutEnd && rows.cellsOfLast() < layout.cells &&
               (kind == LineKind::otherRow || layout.cells <= 3)) {
      cut = true;
    } else {
      if (kind == LineKind::otherRow && others++ == 0) {
        otherAt = rows.table.rows() + 1;
        otherCells = rows.cellsOfLast();
      }
      if (kind == LineKind::otherRow && (parted || further > 0)) ++further;
      parted = kind == LineKind::text;
      if (texts++ == 0) firstText = trimmed;
    }
  }
  if (50 * others > rows.table.rows() + others && further < others) {
    return Error{name + ", row " + std::to_string(otherAt),
                 message("has {} cells, expected {}", otherCells, layout.cells)};
  }
  if (cut) rows.table.remarks.push_back(message("the last line is cut short and was left out"));
  if (texts > 0) rows.table.remarks.push_back(inFewWords(texts, firstText));
  rows.settle(lastGood);
  return {};
}

/// Rows printed as sentences, told as a table.
Result<RawTable> readSentences(const SentenceRows& rows, const std::string& name) {
  auto table = readTextTable(rows.table, name);
  if (!table) return table;
  table->remarks.push_back(message("rows that read as sentences: the words before each number name it"));
  if (rows.leftOut > 0)
    table->remarks.push_back(rows.leftOut == 1
                                 ? message("1 line reads otherwise than the others and was left out")
                                 : message("{} lines read otherwise than the others and were left out", rows.leftOut));
  return table;
}

/// Entries of several lines, told as a table.
Result<RawTable> readEntries(const LineEntries& entries, const std::string& name) {
  auto table = readTextTable(entries.table, name);
  if (!table) return table;
  table->remarks.push_back(
      message("entries of {} lines each are rows: the words before each number name it", entries.lines));
  if (entries.leftOut > 0)
    table->remarks.push_back(entries.leftOut == 1
                                 ? message("1 line is of no entry and was left out")
                                 : message("{} lines are of no entry and were left out", entries.leftOut));
  return table;
}

/// The rows of one of several tables.
Result<RawTable> readTagged(const TaggedRows& rows, const std::string& name) {
  auto table = readTextTable(rows.table, name);
  if (!table) return table;
  table->remarks.push_back(
      rows.leftOut == 1
          ? message("the rows that begin with {} were taken; 1 line that begins otherwise was left out", rows.word)
          : message("the rows that begin with {} were taken; {} lines that begin otherwise were left out", rows.word,
                    rows.leftOut));
  return table;
}

}  // namespace

Result<RawTable> readTextTable(std::string_view text, const std::string& name) {
  std::string buffer;
  std::string_view utf8 = inUtf8(text, buffer);
  if (auto messages = readYamlMessages(utf8, name)) return std::move(*messages);
  if (auto signals = readControlDeskText(utf8, lineEndOf(utf8), name)) return std::move(*signals);
  if (auto signals = readCodesysTrace(utf8, lineEndOf(utf8), name)) return std::move(*signals);
  if (auto variables = readOctaveText(utf8, lineEndOf(utf8), name)) return std::move(*variables);
  if (auto lists = readNamedLists(utf8, name)) return std::move(*lists);
  if (const auto entries = withEntriesAsRows(utf8)) return readEntries(*entries, name);
  if (const auto tagged = withTaggedRowsApart(utf8)) return readTagged(*tagged, name);
  auto flat = withListsInCells(utf8);
  if (!flat) flat = withStampsAsCells(utf8);
  if (flat) {
    utf8 = *flat;
  } else if (const auto sentences = withSentencesAsCells(utf8, SentenceTime::clock)) {
    return readSentences(*sentences, name);
  }
  const char lineEnd = lineEndOf(utf8);
  if (auto signals = readLineProtocol(utf8, lineEnd, name)) return std::move(*signals);
  const auto sample = sampleOf(utf8, lineEnd);
  if (withoutBlanks(utf8.substr(0, 1000)).find_first_not_of("\r\n \t") == std::string_view::npos && sample.empty())
    return Error{name, message("is empty, expected a table")};
  const TextLayout layout = layoutOf(sample);
  const Error none{
      name,
      message(
          "holds no table: expected rows of at least two numbers, separated by commas, semicolons, tabs or blanks")};
  if (layout.cells == 0) {
    const auto sentences = withSentencesAsCells(utf8, SentenceTime::any);
    return sentences ? readSentences(*sentences, name) : none;
  }
  if (layout.cells > mostCells) return none;
  size_t sampled = 0;
  for (const std::string_view line : sample) sampled += line.size() + 1;
  const size_t lineSize = std::max<size_t>(4, sampled / std::max<size_t>(1, sample.size()));
  Rows rows(layout, name, utf8.size() / lineSize + 16);
  RawTable notes;
  const Start start = findStart(utf8, lineEnd, layout, rows, notes);
  if (!start.found) return none;
  std::string_view first = start.rest;
  const TextNames names = namesBefore(start.before, takeLine(first, lineEnd), layout);
  if (auto signals = readLongTable(start.rest, lineEnd, layout, names, name)) return std::move(*signals);
  for (size_t c = 0; c < layout.cells; ++c) {
    rows.table.columns[c].channel.name = names.names[c];
    rows.table.columns[c].unit = names.units[c];
  }
  rows.table.notes = std::move(notes.notes);
  if (const auto done = readRows(start.rest, lineEnd, layout, names, start.before, name, rows); !done)
    return done.error();
  rows.takeLabelColumns();
  rows.takeUnitColumns();
  RawTable table = std::move(rows.table);
  for (const std::string_view line : start.before) table.preamble.emplace_back(withoutBlanks(line));
  std::erase_if(table.columns, [](const RawColumn& column) {
    const auto& values = column.channel.values;
    return !column.fault && column.channel.name.starts_with("column_") &&
           std::all_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
  });
  return table;
}

}  // namespace breakaway
