#include "recording/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/atomic_file.h"
#include "base/exact_text.h"
#include "recording/columns.h"
#include "recording/csv_rows.h"

namespace breakaway {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

/// Takes the next line off `rest`, without its line break.
std::string_view takeCsvLine(std::string_view& rest) {
  const size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

/// Where the cell that begins at `at` ends: at the next comma, or at `end`. A cell that opens with a double quote may
/// hold commas.
const char* cellEnd(const char* at, const char* end) {
  const char* first = std::find_if(at, end, [](char c) { return c != ' ' && c != '\t'; });
  bool quoted = false;
  const bool opens = first < end && *first == '"';
  while (at < end && (quoted || *at != ',')) {
    if (opens && *at == '"') quoted = !quoted;
    ++at;
  }
  return at;
}

/// Without the double quotes around it, those within being doubled.
std::string unquoted(std::string_view text) {
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') return std::string(text);
  std::string plain;
  for (size_t k = 1; k + 1 < text.size(); ++k) {
    plain += text[k];
    if (text[k] == '"' && k + 2 < text.size() && text[k + 1] == '"') ++k;
  }
  return std::string(trimmed(plain));
}

std::string quotedWhereNeeded(const std::string& name) {
  if (name.find(',') == std::string::npos && !name.starts_with('"') && !name.starts_with('#')) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

struct Head {
  std::vector<std::pair<std::string, std::string>> notes;
  std::vector<std::string> columns;
  std::string_view rows;
};

Result<std::vector<std::string>> readColumns(std::string_view line, const std::string& name) {
  if (line.find(',') == std::string_view::npos && line.find_first_of(";\t") != std::string_view::npos) {
    return Error{name + ", header",
                 "is separated by semicolons or tabs, expected commas; breakaway import converts such files"};
  }
  std::vector<std::string> columns;
  const char* at = line.data();
  const char* end = line.data() + line.size();
  while (true) {
    const char* comma = cellEnd(at, end);
    columns.emplace_back(unquoted(trimmed({at, static_cast<size_t>(comma - at)})));
    if (columns.back().empty()) {
      return Error{name + ", header", "column " + std::to_string(columns.size()) + " has no name"};
    }
    if (comma == end) return columns;
    at = comma + 1;
  }
}

Result<Head> readHead(std::string_view text, const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Head head;
  while (!text.empty()) {
    const std::string_view line = trimmed(takeCsvLine(text));
    if (line.empty()) continue;
    if (line.front() == '#') {
      const size_t colon = line.find(':');
      const std::string_view key = trimmed(line.substr(1, colon == std::string_view::npos ? colon : colon - 1));
      const std::string_view value = colon == std::string_view::npos ? "" : trimmed(line.substr(colon + 1));
      head.notes.emplace_back(key, value);
      continue;
    }
    head.rows = text;
    if (auto columns = readColumns(line, name); columns) {
      head.columns = std::move(*columns);
    } else {
      return columns.error();
    }
    return head;
  }
  return Error{name, "is empty, expected a header line with time_s"};
}

Error cellError(const std::string& name, size_t row, const Column& column, std::string_view text, double value) {
  const bool beyond = column.cell == Cell::ratio && std::isfinite(value);
  const std::string expected = column.cell == Cell::flag ? "0 or 1"
                               : beyond                  ? "a duty from -1 to 1"
                                                         : "a finite number";
  return {name + ", row " + std::to_string(row) + ", column " + column.name,
          "expected " + expected + ", found \"" + std::string(text.substr(0, 40)) + "\""};
}

/// What a number beyond a double's range stands for: 0 or the smallest doubles below it, infinity above.
double outOfRange(std::string_view digits) {
  return std::strtod(std::string(digits).c_str(), nullptr);
}

bool allowed(double value, const Column* column) {
  constexpr double mostDuty = 1.02;  // logs round
  if (std::isinf(value)) return false;
  if (column == nullptr || column->cell == Cell::number) return true;
  return column->cell == Cell::ratio ? std::abs(value) <= mostDuty : value >= 0.0 && value <= 1.0;
}

/// One row into the columns' ends; says which column is at fault. `known`: what each column means, if anything.
Result<void> readRow(std::string_view line, size_t row, const std::string& name,
                     const std::vector<const Column*>& known, std::vector<Channel>& channels) {
  const char* at = line.data();
  const char* end = line.data() + line.size();
  for (size_t column = 0; column < channels.size(); ++column) {
    if (at > end) {
      return Error{name + ", row " + std::to_string(row),
                   "has too few cells: " + std::to_string(column) + ", expected " + std::to_string(channels.size())};
    }
    double value = std::numeric_limits<double>::quiet_NaN();
    if (at < end && *at == ' ') {
      while (at < end && *at == ' ') ++at;
    }
    if (at < end && *at != ',') {
      const char* start = at;
      if (*start == '+' && start + 1 < end && start[1] != '-') ++start;
      const auto [stop, code] = std::from_chars(start, end, value);
      const char* after = stop;
      while (after < end && *after == ' ') ++after;
      if (code == std::errc::result_out_of_range) value = outOfRange({start, static_cast<size_t>(stop - start)});
      const bool isNumber = code != std::errc::invalid_argument && (after == end || *after == ',');
      if (!isNumber || !(allowed(value, known[column]) || std::isnan(value))) {
        after = cellEnd(at, end);
        if (known[column] != nullptr)
          return cellError(name, row, *known[column], trimmed({at, static_cast<size_t>(after - at)}),
                           isNumber ? value : std::numeric_limits<double>::quiet_NaN());
        value = std::numeric_limits<double>::quiet_NaN();
      }
      at = after;
    }
    channels[column].values.push_back(value);
    ++at;  // past the comma; beyond the end after the last cell
  }
  if (at <= end)
    return Error{name + ", row " + std::to_string(row),
                 "has more cells than the header's " + std::to_string(channels.size())};
  return {};
}

}  // namespace

Result<Recording> readCsvText(std::string_view text, const std::string& name) {
  auto head = readHead(text, name);
  if (!head) return head.error();
  std::vector<Channel> channels;
  std::vector<const Column*> known;
  // Empty lines are no rows: each row takes at least its commas.
  const auto lines = static_cast<size_t>(std::count(head->rows.begin(), head->rows.end(), '\n')) + 1;
  const size_t rowCount = std::min(lines, head->rows.size() / head->columns.size() + 1);
  for (const std::string& column : head->columns) {
    channels.push_back({column, {}});
    channels.back().values.reserve(rowCount);
    known.push_back(columnNamed(column));
  }
  size_t row = 0;
  std::string_view rest = head->rows;
  while (!rest.empty()) {
    const std::string_view line = takeCsvLine(rest);
    if (line.empty()) continue;
    ++row;
    if (auto done = readRow(line, row, name, known, channels); !done) return done.error();
  }
  if (channels.front().values.empty()) return Error{name, "has a header and no rows"};
  return Recording::seal(name, std::move(channels), std::move(head->notes));
}

Result<Recording> readCsv(const std::string& path) {
  auto content = readFile(path);
  if (!content) return content.error();
  return readCsvText(*content, path);
}

std::string csvHead(const std::vector<std::pair<std::string, std::string>>& notes,
                    const std::vector<std::string>& columns) {
  std::string out;
  for (const auto& [key, value] : notes) {
    std::string note = key + ": " + value;
    std::replace_if(
        note.begin(), note.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    out += "# " + note + "\n";
  }
  for (size_t c = 0; c < columns.size(); ++c) {
    out += c == 0 ? "" : ",";
    out += quotedWhereNeeded(columns[c]);
  }
  return out + '\n';
}

void appendCsvRow(std::string& text, std::span<const double> row) {
  for (size_t c = 0; c < row.size(); ++c) {
    if (c > 0) text += ',';
    if (!std::isnan(row[c])) appendExact(text, row[c]);
  }
  text += '\n';
}

Result<void> writeCsv(const Recording& recording, const std::string& path) {
  const auto& channels = recording.channels();
  std::vector<std::string> names;
  names.reserve(channels.size());
  for (const Channel& one : channels) names.push_back(one.name);
  std::string out = csvHead(recording.notes(), names);
  out.reserve(out.size() + recording.rows() * channels.size() * 12);
  std::vector<double> cells(channels.size());
  for (size_t row = 0; row < recording.rows(); ++row) {
    for (size_t c = 0; c < channels.size(); ++c) cells[c] = channels[c].values[row];
    appendCsvRow(out, cells);
  }
  return writeFile(path, out);
}

Result<std::vector<std::string>> timeTextIn(std::string_view text, const std::string& name) {
  auto head = readHead(text, name);
  if (!head) return head.error();
  const auto it = std::find(head->columns.begin(), head->columns.end(), "time_s");
  if (it == head->columns.end()) return Error{name, "has no column time_s"};
  const auto skip = it - head->columns.begin();
  std::vector<std::string> texts;
  std::string_view rest = head->rows;
  while (!rest.empty()) {
    std::string_view line = takeCsvLine(rest);
    if (line.empty()) continue;
    for (std::ptrdiff_t c = 0; c < skip; ++c) {
      const char* comma = cellEnd(line.data(), line.data() + line.size());
      const auto width = static_cast<size_t>(comma - line.data());
      line.remove_prefix(std::min(width + 1, line.size()));
    }
    texts.emplace_back(trimmed(line.substr(0, line.find(','))));
  }
  return texts;
}

}  // namespace breakaway
