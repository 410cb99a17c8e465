#include "recording/import.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <set>

#include "base/atomic_file.h"
#include "base/exact_text.h"
#include "base/json_object.h"
#include "base/numbers.h"
#include "recording/column_meaning.h"
#include "recording/columns.h"
#include "recording/json_log.h"
#include "recording/known_logs.h"
#include "recording/mat.h"
#include "recording/text_table.h"

namespace breakaway {

namespace {

bool holds(const std::string& column, Quantity quantity) {
  const Column* known = columnNamed(column);
  return known != nullptr && known->quantity == quantity;
}

std::string shortText(double value) {
  return fmt::format("{:.9g}", value);
}

/// Vectors as long as the longest become columns, single values notes.
Result<RawTable> readMatTable(const std::string& path) {
  auto channels = readMat(path);
  if (!channels) return channels.error();
  RawTable table;
  size_t rows = 0;
  for (const Channel& channel : *channels) rows = std::max(rows, channel.values.size());
  if (rows < 2) return Error{path, "holds single numbers only, expected vectors over time"};
  for (Channel& channel : *channels) {
    if (channel.values.size() == rows) {
      table.columns.push_back({std::move(channel), {}});
    } else if (channel.values.size() == 1) {
      table.notes.emplace_back(channel.name, exactText(channel.values.front()));
    } else {
      table.remarks.push_back(channel.name + " has " + std::to_string(channel.values.size()) + " values, not " +
                              std::to_string(rows) + ", and was left out");
    }
  }
  return table;
}

Result<RawTable> readAny(const std::string& path) {
  const auto content = readFile(path);
  if (!content) return content.error();
  const bool mat = content->starts_with("MATLAB ") || content->starts_with("\x89HDF") || path.ends_with(".mat");
  if (mat) return readMatTable(path);
  const size_t start = content->find_first_not_of(" \t\r\n");
  if (start != std::string::npos && ((*content)[start] == '{' || (*content)[start] == '['))
    return readJsonLog(*content, path);
  return readTextTable(*content, path);
}

/// A name that a header line can hold.
std::string plainName(std::string name, size_t column) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c == ',' || c == '"' || c == '#' || c < 0x20; }, '_');
  const size_t start = name.find_first_not_of(' ');
  if (start == std::string::npos) return "column_" + std::to_string(column + 1);
  return name.substr(start, name.find_last_not_of(' ') - start + 1);
}

void convert(std::vector<double>& values, double scale, double offset) {
  if (scale == 1.0 && offset == 0.0) return;
  for (double& value : values) value = scale * value + offset;
}

/// Gives a time without a unit one, by its steps, and counts times of day from the first row.
void settleTime(std::vector<double>& time, bool unitGiven, std::vector<std::string>& remarks) {
  std::vector<double> steps;
  for (size_t k = 1; k < time.size(); ++k) {
    if (std::isfinite(time[k] - time[k - 1])) steps.push_back(time[k] - time[k - 1]);
  }
  if (steps.empty()) return;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  if (!unitGiven && *middle >= 0.5) {
    const bool micro = *middle >= 100.0;
    remarks.push_back("the time has no unit; steps of " + shortText(*middle) + " were taken for " +
                      (micro ? "µs" : "ms"));
    convert(time, micro ? 1e-6 : 1e-3, 0.0);
  }
  constexpr double elevenDays_s = 1e6;
  if (std::isfinite(time.front()) && std::abs(time.front()) > elevenDays_s) {
    remarks.push_back("the time is counted from the first row, which was at " + shortText(time.front()) + " s");
    const double start = time.front();
    for (double& value : time) value -= start;
  }
}

/// An angle that starts anew with each turn goes on counting afterwards: one that stays within a turn, and all of whose
/// leaps are by about a turn.
void settleAngle(std::vector<double>& angle, std::vector<std::string>& remarks) {
  constexpr double nearATurn = 0.5;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double last = std::numeric_limits<double>::quiet_NaN();
  size_t leaps = 0;
  for (const double value : angle) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
    const double step = std::abs(value - last);  // NaN at first
    last = value;
    if (!(step > std::numbers::pi)) continue;
    if (std::abs(step - turn_rad) > nearATurn) return;
    ++leaps;
  }
  if (leaps == 0 || high - low > 1.001 * turn_rad) return;
  double turns = 0.0;
  last = std::numeric_limits<double>::quiet_NaN();
  for (double& value : angle) {
    if (!std::isfinite(value)) continue;
    if (value - last > std::numbers::pi) turns -= turn_rad;
    if (last - value > std::numbers::pi) turns += turn_rad;
    last = value;
    value += turns;
  }
  remarks.push_back("the angle starts anew with each turn, in " + std::to_string(leaps) +
                    (leaps == 1 ? " place" : " places") + "; it goes on counting now");
}

/// The rule for one column: the map's, or what its name means. Nothing: it keeps its name and values.
std::optional<Meaning> ruleFor(const std::string& column, const ImportMap& map) {
  if (const auto it = map.find(column); it != map.end())
    return Meaning{it->second.to, it->second.scale, it->second.offset, true};
  return meaningOf(column);
}

std::string inWords(const std::string& from, const Meaning& meaning) {
  std::string text = from + " → " + meaning.to;
  if (meaning.scale != 1.0) text += ", × " + shortText(meaning.scale);
  if (meaning.offset != 0.0) text += (meaning.offset > 0.0 ? ", + " : ", − ") + shortText(std::abs(meaning.offset));
  if (!meaning.unitGiven && !holds(meaning.to, Quantity::time)) text += ", taken as SI: the name tells no unit";
  return text;
}

Result<void> checkMap(const ImportMap& map, const RawTable& table, const std::string& path) {
  std::vector<std::string> names;
  for (const RawColumn& column : table.columns) names.push_back(column.channel.name);
  for (const auto& [name, rule] : map) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const auto suggestion = nearestName(name, names);
    return Error{path, "has no column \"" + name + "\", which the map names" +
                           (suggestion ? ", did you mean " + *suggestion + "?" : "")};
  }
  return {};
}

Result<Imported> settle(RawTable table, const ImportMap& map, const std::string& path) {
  std::vector<Channel> channels;
  std::vector<std::string> remarks = table.remarks;
  std::set<std::string> taken;
  // Those the map names go first, then exact contract names, so that a guess never pushes them out.
  std::stable_sort(table.columns.begin(), table.columns.end(), [&map](const RawColumn& a, const RawColumn& b) {
    return map.contains(a.channel.name) && !map.contains(b.channel.name);
  });
  for (size_t c = 0; c < table.columns.size(); ++c) {
    RawColumn& column = table.columns[c];
    const std::string from = column.channel.name;
    auto rule = ruleFor(from, map);
    if (rule && taken.contains(rule->to)) {
      if (map.contains(from))
        return Error{path, "two columns become " + rule->to + "; name another one for \"" + from + "\""};
      remarks.push_back(from + " would be a second " + rule->to + " and keeps its name");
      rule.reset();
    }
    if (column.fault) {
      if (rule) return *column.fault;
      remarks.push_back(from + " holds text and was left out");
      continue;
    }
    if (rule) {
      convert(column.channel.values, rule->scale, rule->offset);
      if (holds(rule->to, Quantity::time)) settleTime(column.channel.values, rule->unitGiven, remarks);
      if (rule->to == columnName(Quantity::position, Axis::rotary)) settleAngle(column.channel.values, remarks);
      if (rule->to != from) remarks.push_back(inWords(from, *rule));
      column.channel.name = rule->to;
    } else {
      column.channel.name = plainName(from, c);
    }
    if (!taken.insert(column.channel.name).second) {
      remarks.push_back(from + " stands there twice; the second was left out");
      continue;
    }
    channels.push_back(std::move(column.channel));
  }
  std::string names;
  for (const Channel& channel : channels) names += (names.empty() ? "" : ", ") + channel.name;
  const auto none = [&](Quantity quantity) {
    return std::none_of(taken.begin(), taken.end(), [=](const std::string& name) { return holds(name, quantity); });
  };
  const std::string instead = "; there are: " + names + "; say which with --map";
  if (none(Quantity::time)) return Error{path, "no column could be taken for the time" + instead};
  if (none(Quantity::position)) return Error{path, "no column could be taken for the angle or position" + instead};
  std::stable_partition(channels.begin(), channels.end(),
                        [](const Channel& one) { return holds(one.name, Quantity::time); });
  table.notes.emplace_back("imported from", std::filesystem::path(path).filename().string());
  auto recording = Recording::seal(path, std::move(channels), std::move(table.notes));
  if (!recording) return recording.error();
  return Imported{std::move(*recording), std::move(remarks)};
}

}  // namespace

Result<ImportMap> readImportMap(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  JsonObject columns = root->object("columns");
  ImportMap map;
  for (const std::string& name : columns.objectNames()) {
    JsonObject rule = columns.object(name);
    map[name] = {rule.text("to"), rule.number("scale", 1.0), rule.number("offset", 0.0)};
    if (map[name].to.empty() || map[name].to.find_first_of(",\"#\n") != std::string::npos) {
      rule.fault("to", "expected a column's name without commas, quotes and #");
    }
    if (map[name].scale == 0.0) rule.fault("scale", "is 0, which would leave nothing of the column");
  }
  if (const auto done = root->finish(); !done) return done.error();
  return map;
}

Result<Imported> importRecording(const std::string& path, const ImportMap& map) {
  auto table = readAny(path);
  if (!table) return table.error();
  if (map.empty()) {
    if (const auto known = translateKnownLog(*table, path); !known) return known.error();
  }
  if (const auto fits = checkMap(map, *table, path); !fits) return fits.error();
  return settle(std::move(*table), map, path);
}

}  // namespace breakaway
