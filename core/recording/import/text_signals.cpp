#include "recording/import/text_signals.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <vector>

#include "base/marked_text.h"
#include "recording/import/column_name.h"
#include "recording/import/signal_log.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

constexpr size_t mostSignals = 1000;
constexpr auto nameWords = std::to_array<std::string_view>(
    {"signal", "name", "channel", "variable", "topic", "series", "symbol", "key", "field", "_field", "metric",
     "parameter", "sensor", "signal_name", "signalname", "variable_name", "tag", "tagname", "tag_name"});
constexpr auto valueWords = std::to_array<std::string_view>({"value", "val", "_value", "signal_value", "reading"});
constexpr auto timeWords = std::to_array<std::string_view>({"_time", "stamp", "datetime"});

template <size_t count>
bool isOneOf(std::string_view text, const std::array<std::string_view, count>& words) {
  return std::any_of(words.begin(), words.end(), [text](std::string_view word) { return isSameWord(text, word); });
}

/// Signals in the order in which they first came.
class Signals {
 public:
  void add(const std::string& name, std::string_view unit, const Stamp& stamp, double value) {
    auto known = places_.find(name);
    if (known == places_.end()) {
      if (all_.size() >= mostSignals) return;
      known = places_.emplace(name, all_.size()).first;
      all_.push_back({name, std::string(unit), {}, {}});
    }
    all_[known->second].stamps.push_back(stamp);
    all_[known->second].values.push_back(value);
  }
  const std::vector<Signal>& all() const { return all_; }

 private:
  std::map<std::string, size_t> places_;
  std::vector<Signal> all_;
};

std::optional<TextNumber> numberIn(std::string_view cell, const TextLayout& layout = {}) {
  TextNumber number;
  const TextCell kind = readCell(withoutBlanks(cell), layout, number);
  return kind == TextCell::number || kind == TextCell::clock ? std::optional(number) : std::nullopt;
}

Stamp stampOf(const TextNumber& number) {
  return number.large ? Stamp{number.whole, number.rest} : Stamp{0, number.value};
}

/// "motor,host=a position=1.5,current=2i 1627551892437000000"; whether it is such a line.
bool takeInfluxLine(std::string_view line, Signals& signals) {
  size_t fieldsAt = line.find(' ');
  while (fieldsAt != std::string_view::npos && fieldsAt > 0 && line[fieldsAt - 1] == '\\')
    fieldsAt = line.find(' ', fieldsAt + 1);
  const size_t stampAt = line.rfind(' ');
  if (fieldsAt == std::string_view::npos || stampAt == fieldsAt) return false;
  const std::string_view stampText = line.substr(stampAt + 1);
  const bool digits = stampText.size() >= 10 && std::all_of(stampText.begin(), stampText.end(),
                                                            [](unsigned char c) { return std::isdigit(c) != 0; });
  const auto stamp = digits ? numberIn(stampText) : std::nullopt;
  if (!stamp) return false;
  std::string_view fields = line.substr(fieldsAt + 1, stampAt - fieldsAt - 1);
  bool any = false;
  while (!fields.empty()) {
    const size_t end = std::min(fields.find(','), fields.size());
    std::string_view field = fields.substr(0, end);
    fields.remove_prefix(std::min(end + 1, fields.size()));
    const size_t equals = field.find('=');
    if (equals == std::string_view::npos || equals == 0) return false;
    const std::string_view key = field.substr(0, equals);
    std::string_view value = field.substr(equals + 1);
    if (value.size() > 1 && (value.back() == 'i' || value.back() == 'u')) value.remove_suffix(1);
    if (const auto number = numberIn(value)) signals.add(std::string(key), {}, stampOf(*stamp), number->value);
    any = true;
  }
  return any;
}

/// ">angle:1627551892437:1.5§rad"; whether it is such a line. Without a stamp there is no time to be had.
bool takeTeleplotLine(std::string_view line, Signals& signals) {
  if (!line.starts_with('>')) return false;
  line.remove_prefix(1);
  const size_t first = line.find(':');
  const size_t second = first == std::string_view::npos ? first : line.find(':', first + 1);
  if (second == std::string_view::npos || first == 0) return false;
  std::string_view value = line.substr(second + 1), unit;
  for (const std::string_view mark : {"\u00A7", "|"}) {
    const size_t at = value.find(mark);
    if (at == std::string_view::npos) continue;
    if (mark != "|") unit = withoutBlanks(value.substr(at + mark.size()));
    value = value.substr(0, at);
    unit = unit.substr(0, unit.find('|'));
  }
  const auto stamp = numberIn(line.substr(first + 1, second - first - 1));
  const auto number = numberIn(value);
  if (!stamp || !number) return false;
  signals.add(std::string(line.substr(0, first)), unit, stampOf(*stamp), number->value);
  return true;
}

struct Protocol {
  bool (*take)(std::string_view, Signals&);
  const char* unit;
  MessageText<0> what;
};

constexpr auto protocols = std::to_array<Protocol>(
    {{takeInfluxLine, "ns", marked("InfluxDB's line protocol")}, {takeTeleplotLine, "ms", marked("a Teleplot log")}});

/// Which columns tell what.
struct LongColumns {
  size_t time = 0, name = 0, value = 0;
  std::optional<size_t> unit;
};

std::optional<LongColumns> columnsOf(const TextNames& names, const TextLayout& layout) {
  std::optional<size_t> time, name, value, unit;
  for (size_t c = 0; c < names.names.size(); ++c) {
    const std::string_view text = names.names[c];
    const bool numbers = layout.numeric[c];
    if (numbers && !value && isOneOf(text, valueWords)) {
      value = c;
    } else if (numbers && !time && (isOneOf(text, timeWords) || understandName(text).to == "time_s")) {
      time = c;
    } else if (!numbers && !name && isOneOf(text, nameWords)) {
      name = c;
    } else if (!numbers && !unit && (isSameWord(text, "unit") || isSameWord(text, "units"))) {
      unit = c;
    }
  }
  if (!time || !name || !value) return std::nullopt;
  return LongColumns{*time, *name, *value, unit};
}

}  // namespace

std::optional<Result<RawTable>> readLineProtocol(std::string_view text, char lineEnd, const std::string& name) {
  constexpr size_t looksAt = 20;
  for (const Protocol& protocol : protocols) {
    Signals begun, all;
    std::string_view rest = text;
    size_t lines = 0, good = 0;
    while (!rest.empty() && lines < looksAt) {
      const std::string_view line = withoutBlanks(takeLine(rest, lineEnd));
      if (line.empty() || isComment(line)) continue;
      ++lines;
      good += protocol.take(line, begun) ? 1 : 0;
    }
    if (2 * good <= lines) continue;
    rest = text;
    size_t others = 0;
    while (!rest.empty()) {
      const std::string_view line = withoutBlanks(takeLine(rest, lineEnd));
      if (!line.empty() && !isComment(line) && !protocol.take(line, all)) ++others;
    }
    auto table = tableOfSignals(all.all(), {"time", protocol.unit}, message(protocol.what), name);
    if (table && others > 0)
      table->remarks.push_back(others == 1 ? message("1 line is of another form and left out")
                                           : message("{} lines are of another form and left out", others));
    return table;
  }
  return std::nullopt;
}

std::optional<Result<RawTable>> readLongTable(std::string_view rows, char lineEnd, const TextLayout& layout,
                                              const TextNames& names, const std::string& name) {
  const auto columns = names.found ? columnsOf(names, layout) : std::nullopt;
  if (!columns) return std::nullopt;
  Signals signals;
  bool clock = false;
  size_t others = 0;
  std::vector<std::string_view> cells;
  while (!rows.empty()) {
    const std::string_view line = takeLine(rows, lineEnd);
    const std::string_view trimmed = withoutBlanks(line);
    if (trimmed.empty() || isComment(trimmed)) continue;
    splitCells(line, layout, cells);
    TextNumber stamp, value;
    if (cells.size() != layout.cells) {
      ++others;
      continue;
    }
    const TextCell kind = readCell(cells[columns->time], layout, stamp);
    const bool timed = kind == TextCell::number || kind == TextCell::clock;
    if (!timed || readCell(cells[columns->value], layout, value) != TextCell::number || cells[columns->name].empty()) {
      ++others;
      continue;
    }
    clock = clock || kind == TextCell::clock;
    const std::string_view unit = columns->unit ? cells[*columns->unit] : value.unit;
    signals.add(std::string(cells[columns->name]), unit, stampOf(stamp), value.value);
  }
  StampColumn time{names.names[columns->time], names.units[columns->time], clock};
  if (isSameWord(time.name, "_time")) time.name = "time";
  auto table = tableOfSignals(signals.all(), time, message("a long table"), name);
  if (table && others > 0)
    table->remarks.push_back(others == 1 ? message("1 row holds no signal's number and are left out")
                                         : message("{} rows hold no signal's number and are left out", others));
  return table;
}

bool tellsSignal(std::string_view column) {
  return isOneOf(column, nameWords);
}

bool tellsValue(std::string_view column) {
  return isOneOf(column, valueWords);
}

}  // namespace breakaway
