#include "recording/import/text_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>

#include "recording/import/clock_time.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

constexpr std::string_view arrow = " -> ";
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\0';
}

bool isAnyDigit(char c) {
  return c >= '0' && c <= '9';
}

bool saysMissing(std::string_view text) {
  static constexpr auto words =
      std::to_array<std::string_view>({"nan", "-nan", "na", "n/a", "#n/a", "null", "none", "-", "--", "?", "nan(ind)",
                                       "-nan(ind)", "1.#qnan", "-1.#ind", "1.#ind", "invalid"});
  return text.size() <= 9 && std::any_of(words.begin(), words.end(), [text](std::string_view word) {
           return word.size() == text.size() && std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) {
                    return a == ((b >= 'A' && b <= 'Z') ? static_cast<char>(b - 'A' + 'a') : b);
                  });
         });
}

/// 1 or 0 for "true" and "false", else −1.
int truthOf(std::string_view text) {
  const auto is = [text](std::string_view word) {
    return word.size() == text.size() &&
           std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) { return a == (b | 0x20); });
  };
  return is("true") ? 1 : is("false") ? 0 : -1;
}

/// A decimal comma has digits behind it.
bool isDecimalComma(std::string_view cell) {
  const size_t comma = cell.find(',');
  return comma != std::string_view::npos && comma + 1 < cell.size() && isAnyDigit(cell[comma + 1]) &&
         cell.find(',', comma + 1) == std::string_view::npos;
}

/// "1.234", "-12.345.678,9": one to three digits, of which the first is no 0, and groups of three behind `mark`.
bool hasGroups(std::string_view cell, char mark) {
  if (!cell.empty() && (cell.front() == '-' || cell.front() == '+')) cell.remove_prefix(1);
  const size_t decimals = cell.find(mark == '.' ? ',' : '.');
  if (decimals != std::string_view::npos && decimals + 1 == cell.size()) return false;
  const std::string_view whole = cell.substr(0, decimals);
  if (whole.find(mark) == std::string_view::npos || whole.front() == '0') return false;
  size_t digits = 0;
  for (size_t k = whole.size(); k-- > 0;) {
    if (whole[k] == mark ? digits != 3 : !isAnyDigit(whole[k]) || digits == 3) return false;
    digits = whole[k] == mark ? 0 : digits + 1;
  }
  return digits > 0;
}

/// Parts a large number of plain digits in a whole number and the rest.
void keepAllDigits(const char* start, const char* end, TextNumber& number) {
  int64_t whole = 0;
  const auto [stop, code] = std::from_chars(start, end, whole);
  if (code != std::errc()) return;
  double rest = 0.0;
  if (stop != end) {
    if (*stop != '.') return;
    if (stop + 1 != end) {
      const auto [last, fine] = std::from_chars(stop, end, rest);
      if (fine != std::errc() || last != end) return;
    }
  }
  number.large = true;
  number.whole = whole;
  number.rest = whole < 0 ? -rest : rest;
}

/// "1'234.5", "1 234,5" with a blank that doesn't break: marks that part nothing but thousands, taken out; empty where
/// there are none.
std::string withoutThousands(std::string_view cell) {
  constexpr size_t longest = 40;
  static constexpr auto marks = std::to_array<std::string_view>({"'", "\u2019", "\u00a0", "\u202f", "\u2009"});
  std::string bare(cell.substr(0, longest + 1));
  if (bare.size() > longest) return {};
  bool any = false;
  for (const std::string_view mark : marks) {
    for (size_t at = bare.find(mark); at != std::string::npos; at = bare.find(mark, at)) {
      const size_t behind = at + mark.size();
      size_t digits = 0;
      while (behind + digits < bare.size() && isAnyDigit(bare[behind + digits])) ++digits;
      if (at == 0 || !isAnyDigit(bare[at - 1]) || digits != 3) return {};
      bare.erase(at, mark.size());
      any = true;
    }
  }
  return any ? bare : std::string();
}

/// How the numbers of a text are written.
struct NumberMarks {
  bool decimalComma = false, grouped = false;
};

NumberMarks marksOf(const TextLayout& layout) {
  return {layout.decimalComma, layout.grouped};
}

/// The number that is all of the cell, or, with `unitMayFollow`, its beginning.
bool readNumber(std::string_view cell, NumberMarks marks, bool unitMayFollow, TextNumber& number) {
  const bool comma = marks.decimalComma;
  std::array<char, 64> copy{}, bare{};
  if (marks.grouped && cell.size() < bare.size() && hasGroups(cell, comma ? '.' : ',')) {
    char* behind = std::remove_copy(cell.begin(), cell.end(), bare.begin(), comma ? '.' : ',');
    cell = {bare.data(), static_cast<size_t>(behind - bare.data())};
  }
  const char* start = cell.data();
  const char* end = start + cell.size();
  if (comma && std::memchr(start, ',', cell.size()) != nullptr) {
    if (cell.size() >= copy.size() || !isDecimalComma(cell) || cell.find('.') != std::string_view::npos) return false;
    std::replace_copy(cell.begin(), cell.end(), copy.begin(), ',', '.');
    start = copy.data();
    end = start + cell.size();
  }
  if (*start == '+' && cell.size() > 1 && start[1] != '-') ++start;
  const auto [stop, code] = std::from_chars(start, end, number.value);
  const bool whole = stop == end || (unitMayFollow && stop != start && !isAnyDigit(*stop) && *stop != '.');
  if (!whole || code == std::errc::invalid_argument) return false;
  if (code == std::errc::result_out_of_range) {
    number.value = std::strtod(std::string(start, stop).c_str(), nullptr);  // 0 or the smallest doubles below it
    return std::isfinite(number.value);
  }
  if (!std::isfinite(number.value)) return false;
  if (std::abs(number.value) >= 1e8 && stop - start >= 10) keepAllDigits(start, stop, number);
  return true;
}

/// "0x1F"; eight digits are 32 bits with a sign, as counters have.
bool readHexadecimal(std::string_view cell, TextNumber& number) {
  if (cell.size() < 3 || cell.size() > 10 || cell[0] != '0' || (cell[1] | 0x20) != 'x') return false;
  uint32_t bits = 0;
  const auto [stop, code] = std::from_chars(cell.data() + 2, cell.data() + cell.size(), bits, 16);
  if (code != std::errc() || stop != cell.data() + cell.size()) return false;
  number.value = cell.size() == 10 ? static_cast<double>(static_cast<int32_t>(bits)) : static_cast<double>(bits);
  number.hexadecimal = true;
  return true;
}

/// "1.5 sec", "12.3°".
bool readNumberWithUnit(std::string_view cell, NumberMarks marks, TextNumber& number) {
  if (cell.size() > 40) return false;
  const size_t digit = cell.find_last_of("0123456789");
  const size_t begin = cell.find_first_not_of(' ', digit + 1);
  if (digit == std::string_view::npos || begin == std::string_view::npos) return false;
  const std::string_view unit = cell.substr(begin);
  if (!readNumber(cell.substr(0, digit + 1), marks, false, number) || !isUnit(unit)) return false;
  number.unit = unit;
  return true;
}

std::string_view stampOf(std::string_view line) {
  const size_t at = line.find(arrow);
  if (at == std::string_view::npos || at > 32) return {};
  const std::string_view stamp = withoutBlanks(line.substr(0, at));
  return readClock(stamp) ? stamp : std::string_view{};
}

void splitPlain(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  if (separator == '\t') {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  } else {
    line = withoutBlanks(line);
  }
  if (separator != ';' && !line.empty() && line.back() == ';') line.remove_suffix(1);  // a row's end: "1,2,3;"
  while (true) {
    size_t end = 0;
    if (!line.empty() && line.front() == '"') {
      end = std::min(line.find('"', 1), line.size());
    }
    if (separator == runsOfBlanks) {
      end = line.find_first_of(" \t", end);
    } else {
      const void* at = end < line.size() ? std::memchr(line.data() + end, separator, line.size() - end) : nullptr;
      end = at == nullptr ? std::string_view::npos : static_cast<size_t>(static_cast<const char*>(at) - line.data());
    }
    std::string_view cell = withoutBlanks(line.substr(0, end));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = withoutBlanks(cell.substr(1, cell.size() - 2));
    cells.push_back(cell);
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
    if (separator == runsOfBlanks) line = withoutBlanks(line);
    while (separator != '\t' && separator != runsOfBlanks && !line.empty() && isBlank(line.front()))
      line.remove_prefix(1);
  }
}

struct Trial {
  TextLayout layout;
  double score = 0.0;
  bool complete = false;  ///< each line holds nothing but numbers and times
};

/// Which mark the decimals have. One that stands only before groups of three digits, where the other one doesn't, parts
/// thousands.
void findMarks(const std::vector<std::string_view>& lines, TextLayout& layout) {
  bool commas = false, commaDecimals = false, commaGroups = false, dotDecimals = false, dotGroups = false;
  std::vector<std::string_view> cells;
  TextNumber number;
  for (const std::string_view line : lines) {
    splitCells(line, layout, cells);
    for (const std::string_view cell : cells) {
      const bool comma = isDecimalComma(cell) && readNumber(cell, {true, false}, false, number);
      const bool groupedByComma = hasGroups(cell, ','), groupedByDot = hasGroups(cell, '.');
      commas = commas || comma;
      commaGroups = commaGroups || groupedByComma;
      dotGroups = dotGroups || groupedByDot;
      commaDecimals = commaDecimals || (comma && !groupedByComma) || (groupedByDot && cell.find(',') < cell.size());
      const bool dot = cell.find('.') < cell.size() && readNumber(cell, {false, false}, false, number);
      dotDecimals = dotDecimals || (dot && !groupedByDot) || (groupedByComma && cell.find('.') < cell.size());
    }
  }
  const bool byCommas = commaGroups && dotDecimals && !commaDecimals;
  layout.decimalComma = (commas || (dotGroups && commaDecimals)) && !byCommas;
  layout.grouped = byCommas || (dotGroups && commaDecimals && !dotDecimals);
}

/// How well the lines read in this layout, with the number of cells in which they read best.
Trial tryLayout(const std::vector<std::string_view>& lines, TextLayout layout) {
  std::vector<std::string_view> cells;
  TextNumber number;
  if (!layout.labelled) findMarks(lines, layout);
  std::map<size_t, double> scores;
  std::map<size_t, size_t> whole;  // lines that hold nothing but numbers and times
  for (const std::string_view line : lines) {
    splitCells(line, layout, cells);
    const bool parted =
        layout.separator == runsOfBlanks && std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
          return std::count(cell.begin(), cell.end(), ',') + std::count(cell.begin(), cell.end(), ';') > 2;
        });
    if (parted) continue;  // blanks within cells: "…,1,ok,01 64 00"
    size_t numbers = 0, filled = 0;
    for (const std::string_view cell : cells) {
      const TextCell kind = readCell(cell, layout, number);
      numbers += kind == TextCell::number || kind == TextCell::clock ? 1 : 0;
      filled += cell.empty() ? 0 : 1;
    }
    if (numbers == 0 || 2 * numbers < filled) continue;
    if (numbers == filled) ++whole[cells.size()];
    const auto count = static_cast<double>(numbers);
    scores[cells.size()] += count * count / static_cast<double>(filled);
  }
  Trial trial{layout, 0.0};
  for (const auto& [size, score] : scores) {
    if (size < 2 || score <= trial.score) continue;
    trial.score = score;
    trial.layout.cells = size;
  }
  trial.complete = trial.layout.cells > 1 && whole.contains(trial.layout.cells) &&
                   10 * whole.at(trial.layout.cells) >= 9 * lines.size();
  return trial;
}

/// A number in each line; no cells if it isn't so.
TextLayout oneColumn(const std::vector<std::string_view>& lines) {
  constexpr size_t fewestLines = 20;
  TextLayout layout;
  layout.separator = ';';
  TextNumber number;
  const auto numbers = [&] {
    return static_cast<size_t>(std::count_if(lines.begin(), lines.end(), [&](std::string_view line) {
      return readNumber(withoutBlanks(line), marksOf(layout), false, number);
    }));
  };
  if (lines.size() < fewestLines) return layout;
  for (const bool comma : {false, true}) {
    layout.decimalComma = comma;
    if (10 * numbers() < 9 * lines.size()) continue;
    layout.cells = 1;
    break;
  }
  return layout;
}

void findNumericColumns(const std::vector<std::string_view>& lines, TextLayout& layout) {
  std::vector<size_t> numbers(layout.cells), texts(layout.cells);
  std::vector<std::string_view> cells;
  TextNumber number;
  size_t rows = 0;
  for (const std::string_view line : lines) {
    splitCells(line, layout, cells);
    if (cells.size() != layout.cells) continue;
    std::vector<TextCell> kinds;
    size_t good = 0, bad = 0;
    for (const std::string_view cell : cells) {
      kinds.push_back(readCell(cell, layout, number));
      good += kinds.back() == TextCell::number || kinds.back() == TextCell::clock ? 1 : 0;
      bad += kinds.back() == TextCell::text ? 1 : 0;
    }
    if (good == 0 || bad > good) continue;  // names or units
    ++rows;
    for (size_t c = 0; c < cells.size(); ++c) {
      numbers[c] += kinds[c] == TextCell::number || kinds[c] == TextCell::clock ? 1 : 0;
      texts[c] += kinds[c] == TextCell::text ? 1 : 0;
    }
  }
  for (size_t c = 0; c < layout.cells; ++c) layout.numeric.push_back(numbers[c] > texts[c] && 20 * numbers[c] > rows);
}

}  // namespace

std::string_view withoutBlanks(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

char lineEndOf(std::string_view text) {
  return text.find('\n') == std::string_view::npos ? '\r' : '\n';
}

std::string_view takeLine(std::string_view& rest, char end) {
  const void* at = rest.empty() ? nullptr : std::memchr(rest.data(), end, rest.size());
  const size_t size = at == nullptr ? rest.size() : static_cast<size_t>(static_cast<const char*>(at) - rest.data());
  const std::string_view line = rest.substr(0, size);
  rest.remove_prefix(at == nullptr ? size : size + 1);
  return line;
}

bool isComment(std::string_view trimmedLine) {
  return !trimmedLine.empty() &&
         (trimmedLine.front() == '#' || trimmedLine.front() == '%' || trimmedLine.starts_with("//"));
}

void splitCells(std::string_view line, const TextLayout& layout, std::vector<std::string_view>& cells) {
  cells.clear();
  if (layout.stamped) {
    cells.push_back(stampOf(line));
    if (!cells.front().empty()) line.remove_prefix(line.find(arrow) + arrow.size());
  }
  splitPlain(line, layout.separator, cells);
}

std::string_view labelOf(std::string_view cell) {
  const size_t mark = cell.find_last_of(":=");
  return mark == std::string_view::npos ? std::string_view{} : withoutBlanks(cell.substr(0, mark));
}

std::string_view unitBehind(std::string_view cell) {
  const size_t last = cell.find_last_of("0123456789");
  if (last == std::string_view::npos) return {};
  while (!cell.empty() && std::string_view(",;|").find(cell.back()) != std::string_view::npos) cell.remove_suffix(1);
  return last < cell.size() ? withoutBlanks(cell.substr(last + 1)) : std::string_view{};
}

TextCell readCell(std::string_view cell, const TextLayout& layout, TextNumber& number) {
  number = {missing, 0, 0.0, false};
  if (cell.empty()) return TextCell::missing;
  if (layout.labelled) {
    const size_t mark = cell.find_last_of(":=");
    if (mark != std::string_view::npos && mark > 0) {
      cell = withoutBlanks(cell.substr(mark + 1));
      if (cell.empty()) return TextCell::missing;
    }
  }
  if (readNumber(cell, marksOf(layout), layout.labelled, number)) return TextCell::number;
  if (const std::string bare = withoutThousands(cell);
      !bare.empty() && readNumber(bare, marksOf(layout), false, number))
    return TextCell::number;
  number = {missing, 0, 0.0, false};
  if (readHexadecimal(cell, number)) return TextCell::number;
  if (isAnyDigit(cell.front()) || cell.front() == '[') {
    const auto clock = readClock(cell);
    if (!clock && readNumberWithUnit(cell, marksOf(layout), number)) return TextCell::number;
    if (!clock) {
      number = {missing, 0, 0.0, false};
      return TextCell::text;
    }
    number = {static_cast<double>(clock->whole_s) + clock->fraction_s, clock->whole_s, clock->fraction_s, true};
    return TextCell::clock;
  }
  if (saysMissing(cell)) return TextCell::missing;
  if (cell.size() > 1 && (cell.front() == '-' || cell.front() == '+')) {
    if (readNumberWithUnit(cell, marksOf(layout), number)) return TextCell::number;
    number = {missing, 0, 0.0, false};
  }
  const int truth = truthOf(cell);
  if (truth < 0) return TextCell::text;
  number.value = truth;
  return TextCell::number;
}

TextLayout layoutOf(const std::vector<std::string_view>& lines) {
  const auto stamps = static_cast<size_t>(
      std::count_if(lines.begin(), lines.end(), [](std::string_view line) { return !stampOf(line).empty(); }));
  Trial best;
  for (const bool labelled : {false, true}) {
    if (labelled && best.layout.cells >= 2) break;
    for (const char separator : {'\t', ';', '|', ',', runsOfBlanks}) {
      // A date and a time of day with a blank between them are one cell.
      if (separator == runsOfBlanks && !labelled && best.complete) continue;
      TextLayout layout;
      layout.separator = separator;
      layout.labelled = labelled;
      layout.stamped = 2 * stamps > lines.size();
      const Trial trial = tryLayout(lines, layout);
      if (trial.score > best.score) best = trial;
    }
  }
  if (best.layout.cells < 2) best.layout = oneColumn(lines);
  if (best.layout.cells > 0) findNumericColumns(lines, best.layout);
  return best.layout;
}

}  // namespace breakaway
