#include "recording/text_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include "recording/column_meaning.h"

namespace breakaway {

namespace {

constexpr char blanks = ' ';  // as a separator: any run of blanks and tabs

enum class Cell { number, missing, text };

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

bool isOneOf(std::string_view text, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [text](std::string_view word) {
    return word.size() == text.size() && std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) {
             return a == ((b >= 'A' && b <= 'Z') ? static_cast<char>(b - 'A' + 'a') : b);
           });
  });
}

/// What a cell says. `comma`: the decimal mark is a comma.
Cell read(std::string_view cell, bool comma, double& value) {
  value = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) return Cell::missing;
  std::array<char, 64> copy{};
  const char* start = cell.data();
  const char* end = start + cell.size();
  if (comma && cell.size() < copy.size()) {
    if (cell.find('.') != std::string_view::npos) return Cell::text;
    std::replace_copy(cell.begin(), cell.end(), copy.begin(), ',', '.');
    start = copy.data();
    end = start + cell.size();
  }
  if (*start == '+' && cell.size() > 1 && start[1] != '-') ++start;
  const auto [stop, code] = std::from_chars(start, end, value);
  if (code == std::errc() && stop == end && std::isfinite(value)) return Cell::number;
  const bool tiny = code == std::errc::result_out_of_range && stop == end;
  value = tiny ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  if (tiny) return std::isinf(std::strtod(std::string(start, end).c_str(), nullptr)) ? Cell::text : Cell::number;
  if (isOneOf(cell, {"nan", "na", "n/a", "null", "none", "-", "--"})) return Cell::missing;
  if (!isOneOf(cell, {"true", "false"})) return Cell::text;
  value = isOneOf(cell, {"true"}) ? 1.0 : 0.0;
  return Cell::number;
}

void split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  line = separator == blanks || separator != '\t' ? trimmed(line) : line.substr(0, line.find_last_not_of('\r') + 1);
  while (true) {
    size_t end = 0;
    if (!line.empty() && line.front() == '"') end = std::min(line.find('"', 1), line.size());
    end = separator == blanks ? line.find_first_of(" \t", end) : line.find(separator, end);
    std::string_view cell = trimmed(line.substr(0, end));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back(cell);
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
    if (separator == blanks) line = trimmed(line);
  }
}

bool isComment(std::string_view line) {
  return line.front() == '#' || line.front() == '%' || line.starts_with("//");
}

struct Lines {
  std::vector<std::string_view> all;  ///< without blank lines
  std::vector<size_t> table;          ///< those of `all` that are no comments
};

Lines linesOf(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const size_t end = text.find_first_of("\r\n");
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (trimmed(line).empty()) continue;
    if (!isComment(trimmed(line))) lines.table.push_back(lines.all.size());
    lines.all.push_back(line);
  }
  return lines;
}

struct Layout {
  char separator = ',';
  bool comma = false;
  size_t cells = 0;
  double numbers = 0.0;  ///< mean count of numbers per row
};

bool looksLikeDecimalComma(std::string_view cell) {
  double value = 0.0;
  return cell.find(',') != std::string_view::npos && read(cell, true, value) == Cell::number;
}

/// How well the last rows read with this separator.
Layout tryLayout(const Lines& lines, char separator) {
  Layout layout{separator};
  const size_t count = lines.table.size();
  const size_t end = count > 2 ? count - 1 : count;  // the very last line may be cut short
  const size_t first = end > 60 ? end - 60 : std::min<size_t>(end, 1);
  std::map<size_t, size_t> sizes;
  std::vector<std::string_view> cells;
  const auto row = [&](size_t k) { split(lines.all[lines.table[k]], separator, cells); };
  for (size_t k = first; k < end; ++k) {
    row(k);
    ++sizes[cells.size()];
    layout.comma = layout.comma || (separator != ',' && std::any_of(cells.begin(), cells.end(), looksLikeDecimalComma));
  }
  for (const auto& [size, often] : sizes) {
    if (size >= 2 && (layout.cells == 0 || often > sizes[layout.cells])) layout.cells = size;
  }
  double value = 0.0;
  for (size_t k = first; k < end; ++k) {
    row(k);
    if (cells.size() != layout.cells) continue;
    const auto numbers = std::count_if(cells.begin(), cells.end(),
                                       [&](auto cell) { return read(cell, layout.comma, value) == Cell::number; });
    layout.numbers += static_cast<double>(numbers) / static_cast<double>(end - first);
  }
  return layout;
}

/// The first line of the table that is a row: as many cells, and numbers as in the sample.
size_t firstRow(const Lines& lines, const Layout& layout) {
  std::vector<std::string_view> cells;
  double value = 0.0;
  for (size_t k = 0; k < lines.table.size(); ++k) {
    split(lines.all[lines.table[k]], layout.separator, cells);
    const auto numbers = std::count_if(cells.begin(), cells.end(),
                                       [&](auto cell) { return read(cell, layout.comma, value) == Cell::number; });
    if (cells.size() == layout.cells && static_cast<double>(numbers) >= 0.5 * layout.numbers) return k;
  }
  return lines.table.size();
}

bool areUnits(const std::vector<std::string_view>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.empty() || isUnit(cell); }) &&
         std::any_of(cells.begin(), cells.end(), [](std::string_view cell) { return !cell.empty(); });
}

/// The columns' names, from the lines before table line `row`.
std::vector<std::string> namesBefore(const Lines& lines, const Layout& layout, size_t row) {
  std::vector<std::string_view> cells, units;
  const auto fits = [&](std::string_view line) {
    split(line, layout.separator, cells);
    if (cells.size() == layout.cells) return true;
    split(line, ',', cells);  // names parted by commas over numbers parted by blanks
    return layout.separator == blanks && cells.size() == layout.cells;
  };
  bool found = row > 0 && fits(lines.all[lines.table[row - 1]]);
  if (found && row > 1 && areUnits(cells)) {
    units = cells;
    found = fits(lines.all[lines.table[row - 2]]);
  }
  if (!found && row < lines.table.size() && lines.table[row] > 0) {
    std::string_view line = trimmed(lines.all[lines.table[row] - 1]);  // a header behind a comment mark
    found = isComment(line);
    if (found)
      found = fits(trimmed(line.substr(line.find_first_not_of("#%/ \t") == std::string_view::npos
                                           ? line.size()
                                           : line.find_first_not_of("#%/ \t"))));
  }
  std::vector<std::string> names;
  for (size_t c = 0; c < layout.cells; ++c) {
    names.push_back(found ? std::string(cells[c]) : "column_" + std::to_string(c + 1));
    if (found && c < units.size() && !units[c].empty()) names.back() += " [" + std::string(trimmed(units[c])) + "]";
  }
  return names;
}

Result<void> readRows(const Lines& lines, const Layout& layout, size_t first, const std::string& name,
                      RawTable& table) {
  std::vector<std::string_view> cells;
  for (auto& column : table.columns) column.channel.values.reserve(lines.table.size() - first);
  for (size_t k = first; k < lines.table.size(); ++k) {
    const std::string row = std::to_string(k - first + 1);
    split(lines.all[lines.table[k]], layout.separator, cells);
    if (cells.size() != layout.cells) {
      if (k + 1 == lines.table.size() && cells.size() < layout.cells) {
        table.remarks.push_back("the last line is cut short and was left out");
        return {};
      }
      return Error{name + ", row " + row,
                   "has " + std::to_string(cells.size()) + " cells, expected " + std::to_string(layout.cells)};
    }
    for (size_t c = 0; c < cells.size(); ++c) {
      RawColumn& column = table.columns[c];
      double value = 0.0;
      const Cell kind = read(cells[c], layout.comma, value);
      column.channel.values.push_back(value);
      if (kind == Cell::text && !column.fault) {
        column.fault = Error{name + ", row " + row + ", column " + column.channel.name,
                             "expected a number, found \"" + std::string(cells[c].substr(0, 40)) + "\""};
      }
    }
  }
  return {};
}

/// UTF-16 with its byte order mark as UTF-8; everything else as it is, without a UTF-8 mark.
std::string inUtf8(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) return std::string(text.substr(3));
  const bool little = text.starts_with("\xFF\xFE");
  if (!little && !text.starts_with("\xFE\xFF")) return std::string(text);
  std::string out;
  for (size_t k = 2; k + 1 < text.size(); k += 2) {
    const auto low = static_cast<unsigned char>(text[k + (little ? 0 : 1)]);
    const unsigned code = low + 256U * static_cast<unsigned char>(text[k + (little ? 1 : 0)]);
    if (code < 0x80U) {
      out += static_cast<char>(code);
    } else if (code < 0x800U) {
      out += static_cast<char>(0xC0U | (code >> 6U));
      out += static_cast<char>(0x80U | (code & 0x3FU));
    } else {
      out += '?';  // nothing in a log's numbers, names or units
    }
  }
  return out;
}

}  // namespace

Result<RawTable> readTextTable(std::string_view text, const std::string& name) {
  const std::string utf8 = inUtf8(text);
  const Lines lines = linesOf(utf8);
  if (lines.all.empty()) return Error{name, "is empty, expected a table"};
  Layout best;
  for (const char separator : {'\t', ';', '|', blanks, ','}) {
    const Layout layout = tryLayout(lines, separator);
    if (layout.numbers > best.numbers) best = layout;
  }
  const size_t first = firstRow(lines, best);
  if (best.cells < 2 || best.numbers < 1.0 || first == lines.table.size()) {
    return Error{
        name, "holds no table: expected rows of at least two numbers, separated by commas, semicolons, tabs or blanks"};
  }
  RawTable table;
  for (auto& column : namesBefore(lines, best, first)) table.columns.push_back({{std::move(column), {}}, {}});
  for (const std::string_view line : lines.all) {
    const size_t colon = line.find(':');
    if (!isComment(trimmed(line)) || colon == std::string_view::npos) continue;
    const std::string_view key = trimmed(line.substr(0, colon));
    const size_t start = key.find_first_not_of("#%/ \t");
    if (start != std::string_view::npos) table.notes.emplace_back(key.substr(start), trimmed(line.substr(colon + 1)));
  }
  if (const auto done = readRows(lines, best, first, name, table); !done) return done.error();
  std::erase_if(table.columns, [](const RawColumn& column) {
    const auto& values = column.channel.values;
    return column.channel.name.empty() &&
           std::all_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
  });
  return table;
}

}  // namespace breakaway
