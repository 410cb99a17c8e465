#include "recording/import/known_scopes.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "recording/import/name_parts.h"
#include "recording/import/number_text.h"
#include "recording/import/told_rate.h"

namespace breakaway {

namespace {

std::vector<std::string> cellsOf(std::string_view line) {
  const char separator = line.find('\t') != std::string_view::npos  ? '\t'
                         : line.find(';') != std::string_view::npos ? ';'
                                                                    : ',';
  std::vector<std::string> cells;
  while (true) {
    const size_t end = line.find(separator);
    std::string cell(line.substr(0, end));
    const size_t first = cell.find_first_not_of(" \"\r"), last = cell.find_last_not_of(" \"\r");
    cells.push_back(first == std::string::npos ? std::string() : cell.substr(first, last - first + 1));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

/// The number that the text begins with, decimal comma or point.
std::optional<double> numberIn(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  double value = 0.0;
  const char* start = text.c_str() + (text.starts_with("+") ? 1 : 0);
  const auto [stop, code] = std::from_chars(start, text.c_str() + text.size(), value);
  if (code != std::errc() || stop == start || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// "1e-6" of the line that begins with this word.
std::optional<double> valueOf(const RawTable& table, std::string_view key) {
  for (const std::string& line : table.preamble) {
    const auto cells = cellsOf(line);
    if (cells.size() >= 2 && lowered(cells[0]) == key) return numberIn(cells[1]);
  }
  return std::nullopt;
}

void addTime(RawTable& table, double start_s, double step_s) {
  RawColumn time;
  time.channel.name = "time";
  time.unit = "s";
  for (size_t k = 0; k < table.rows(); ++k) time.channel.values.push_back(start_s + step_s * static_cast<double>(k));
  table.columns.insert(table.columns.begin(), std::move(time));
}

bool isEmpty(const RawColumn& column) {
  return std::all_of(column.channel.values.begin(), column.channel.values.end(),
                     [](double v) { return std::isnan(v); });
}

std::optional<ToolColumns> labview(RawTable& table) {
  if (table.preamble.empty() || !table.preamble.front().starts_with("LabVIEW Measurement")) return std::nullopt;
  for (const std::string& line : table.preamble) {
    const auto cells = cellsOf(line);
    if (cells.empty() || cells[0] != "Y_Unit_Label") continue;
    const size_t first = !table.columns.empty() && table.columns.front().channel.name == "X_Value" ? 1 : 0;
    for (size_t c = 1; c < cells.size() && c + first <= table.columns.size(); ++c)
      table.columns[c + first - 1].unit = cells[c];
  }
  table.remarks.push_back(message("recognised LabVIEW's measurement file"));
  std::erase_if(table.columns, [](const RawColumn& one) { return one.channel.name == "X_Value" && isEmpty(one); });
  const bool hasX = !table.columns.empty() && table.columns.front().channel.name == "X_Value";
  if (hasX) {
    table.columns.front().unit = "s";
    table.columns.front().channel.name = "time (X_Value)";
  } else if (const auto step = valueOf(table, "delta_x")) {
    addTime(table, valueOf(table, "x0").value_or(0.0), *step);
  }
  return ToolColumns{};
}

/// X, CH1, …, Start, Increment; below the names a line of units with the two numbers.
std::optional<ToolColumns> rigol(RawTable& table) {
  for (size_t k = 0; k + 1 < table.preamble.size(); ++k) {
    const auto names = cellsOf(table.preamble[k]), units = cellsOf(table.preamble[k + 1]);
    if (names.size() < 4 || names.front() != "X" || lowered(units.front()) != "sequence") continue;
    const auto at = static_cast<size_t>(std::find(names.begin(), names.end(), "Start") - names.begin());
    if (at + 1 >= names.size() || at + 1 >= units.size() || names[at + 1] != "Increment") continue;
    const auto start = numberIn(units[at]), step = numberIn(units[at + 1]);
    if (!start || !step || at > table.columns.size()) continue;
    table.columns.resize(at);
    for (size_t c = 1; c < at; ++c) {
      table.columns[c].channel.name = names[c];
      table.columns[c].unit = units[c];
    }
    RawColumn& time = table.columns.front();
    time.channel.name = "time";
    time.unit = "s";
    for (double& value : time.channel.values) value = *start + *step * value;
    table.remarks.push_back(message("recognised a Rigol oscilloscope: rows are {} s apart", shortText(*step)));
    return ToolColumns{};
  }
  return std::nullopt;
}

/// The first columns hold the head, a few rows long; time and value stand in the fourth and fifth.
std::optional<ToolColumns> tektronix(RawTable& table) {
  if (table.columns.empty() || !table.columns.front().fault ||
      table.columns.front().fault->fact.find("Record Length") == std::string::npos)
    return std::nullopt;
  std::erase_if(table.columns, [](const RawColumn& one) {
    size_t there = 0;
    for (const double value : one.channel.values) there += std::isfinite(value) ? 1 : 0;
    return 2 * there < one.channel.values.size();
  });
  if (table.columns.size() < 2) return std::nullopt;
  table.columns[0].channel.name = "time";
  table.columns[0].unit = "s";
  for (size_t c = 1; c < table.columns.size(); ++c) {
    table.columns[c].channel.name = "CH" + std::to_string(c);
    table.columns[c].unit = "V";
  }
  table.remarks.push_back(message("recognised a Tektronix oscilloscope"));
  return ToolColumns{};
}

/// TwinCAT's scope: a time and a value for each variable, whose names stand in a line that begins with "Name".
std::optional<ToolColumns> twincat(RawTable& table) {
  std::vector<std::string> names, units;
  for (const std::string& line : table.preamble) {
    auto cells = cellsOf(line);
    if (cells.size() < 4 || cells.size() != table.columns.size() || cells.size() % 2 != 0) continue;
    const bool pairs = cells[0] == cells[2];
    if (pairs && cells[0] == "Name") names = cells;
    if (pairs && cells[0] == "Unit") units = cells;
  }
  if (names.empty()) return std::nullopt;
  for (size_t c = 1; c < names.size(); c += 2) {
    table.columns[c].channel.name = names[c];
    table.columns[c].unit = c < units.size() ? units[c] : std::string();
    table.columns[c - 1].channel.name = c == 1 ? "time" : "time of " + names[c];
    table.columns[c - 1].unit = "ms";
    if (c > 1 && table.columns[c - 1].channel.values != table.columns[0].channel.values)
      table.columns[c].fault = Error{names[c], message("has times of its own, other than {}", names[1])};
  }
  table.remarks.push_back(message("recognised TwinCAT's scope: the first variable's times, in ms"));
  return ToolColumns{};
}

void takeInterval(RawTable& table) {
  const bool timed = std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& one) {
    return one.clock || understandName(one.channel.name, one.unit).to == "time_s";
  });
  if (timed || table.columns.empty()) return;
  const auto told = toldStep_s(table);
  if (!told) return;
  addTime(table, 0.0, *told);
  table.remarks.push_back(message("the time is made of the head's sample interval, {} s", shortText(*told)));
}

}  // namespace

std::optional<ToolColumns> recogniseScope(RawTable& table) {
  if (auto known = labview(table)) return known;
  if (auto known = rigol(table)) return known;
  if (auto known = tektronix(table)) return known;
  if (auto known = twincat(table)) return known;
  takeInterval(table);
  return std::nullopt;
}

}  // namespace breakaway
