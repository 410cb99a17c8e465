#include "recording/import/text_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recording/import/codesys_trace.h"
#include "recording/import/controldesk.h"
#include "recording/import/line_entries.h"
#include "recording/import/list_cells.h"
#include "recording/import/marked_lines.h"
#include "recording/import/named_lists.h"
#include "recording/import/octave_text.h"
#include "recording/import/sentence_rows.h"
#include "recording/import/stamped_lines.h"
#include "recording/import/tagged_rows.h"
#include "recording/import/text_encoding.h"
#include "recording/import/text_layout.h"
#include "recording/import/text_names.h"
#include "recording/import/text_rows.h"
#include "recording/import/text_signals.h"
#include "recording/import/units.h"
#include "recording/import/yaml_messages.h"

namespace breakaway {

namespace {

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

Start findStart(std::string_view text, char lineEnd, const TextLayout& layout, TextRows& rows, RawTable& notes) {
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
                      const std::vector<std::string_view>& before, const std::string& name, TextRows& rows) {
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

/// Lines that begin alike, without what they begin with.
Result<RawTable> readMarked(const MarkedLines& lines, const std::string& name) {
  auto table = readTextTable(lines.text, name);
  if (table)
    table->remarks.push_back(message("each line begins with \"{}\", which is no part of the table", lines.mark));
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
  if (const auto marked = withoutMarkOfLines(utf8)) return readMarked(*marked, name);
  if (const auto entries = withEntriesAsRows(utf8)) return readEntries(*entries, name);
  if (const auto tagged = withTaggedRowsApart(utf8)) return readTagged(*tagged, name);
  auto flat = withListsInCells(utf8);
  if (!flat) flat = withStampsAsCells(utf8);
  if (!flat) flat = withStampsBeforeRows(utf8);
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
  const auto asSentences = [&]() -> Result<RawTable> {
    const auto sentences = withSentencesAsCells(utf8, SentenceTime::any);
    return sentences ? readSentences(*sentences, name) : none;
  };
  if (layout.cells == 0) return asSentences();
  if (layout.cells > mostCellsOfARow) return none;
  size_t sampled = 0;
  for (const std::string_view line : sample) sampled += line.size() + 1;
  const size_t lineSize = std::max<size_t>(4, sampled / std::max<size_t>(1, sample.size()));
  TextRows rows(layout, name, utf8.size() / lineSize + 16);
  RawTable notes;
  const Start start = findStart(utf8, lineEnd, layout, rows, notes);
  if (!start.found) return asSentences();
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
  if (layout.grouped)
    rows.table.remarks.push_back(layout.decimalComma ? message("dots part thousands: 1.234 is taken as 1234")
                                                     : message("commas part thousands: 1,234 is taken as 1234"));
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
