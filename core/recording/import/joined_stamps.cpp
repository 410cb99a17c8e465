#include "recording/import/joined_stamps.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "recording/import/settle_motion.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

using ColumnPlace = std::vector<RawColumn>::iterator;

/// Stamps in two columns, seconds and nanoseconds, become one.
void joinColumns(RawTable& table, ColumnPlace seconds, ColumnPlace nanos) {
  auto& values = seconds->channel.values;
  if (seconds->origin == 0.0 && !values.empty() && std::abs(values.front()) > 1e6) {
    seconds->origin = std::floor(values.front());  // since 1970: a double has no room for nanoseconds beside these
    for (double& value : values) value -= seconds->origin;
  }
  for (size_t k = 0; k < values.size(); ++k) values[k] += 1e-9 * (nanos->channel.values[k] + nanos->origin);
  seconds->unit = "s";
  table.remarks.push_back(message("{} and {} are one stamp", seconds->channel.name, nanos->channel.name));
  seconds->channel.name.insert(0, "stamp (");
  seconds->channel.name += ')';
  table.columns.erase(nanos);
}

/// A message per row without names, as `ros2 topic echo --csv` prints it, begins with its stamp.
void joinNamelessStamps(RawTable& table) {
  const bool nameless = table.rows() > 1 && table.columns.size() > 2 &&
                        std::all_of(table.columns.begin(), table.columns.end(),
                                    [](const RawColumn& one) { return one.channel.name.starts_with("column_"); });
  if (!nameless || table.columns[0].fault || table.columns[1].fault) return;
  const auto all = [&table](size_t c, double from, double below) {
    const auto& values = table.columns[c].channel.values;
    return areWhole(values) && std::all_of(values.begin(), values.end(), [&](double value) {
             const double whole = value + table.columns[c].origin;
             return whole >= from && whole < below;
           });
  };
  constexpr double year2001_s = 1e9, farAway_s = 4e9, second_ns = 1e9, manyNanoseconds = 1e6;
  if (all(0, year2001_s, farAway_s) && all(1, 0.0, second_ns) &&
      largest(table.columns[1].channel.values) > manyNanoseconds)
    joinColumns(table, table.columns.begin(), table.columns.begin() + 1);
}

}  // namespace

void joinStamps(RawTable& table) {
  const auto endsIn = [](const std::string& name, std::initializer_list<const char*> words) {
    const auto parts = wordsOf(name, false);
    return !parts.empty() &&
           std::any_of(words.begin(), words.end(), [&](const char* word) { return parts.back() == word; });
  };
  const auto seconds = std::find_if(table.columns.begin(), table.columns.end(), [&](const RawColumn& one) {
    return !one.fault && endsIn(one.channel.name, {"sec", "secs"});
  });
  const auto nanos = std::find_if(table.columns.begin(), table.columns.end(), [&](const RawColumn& one) {
    return !one.fault && endsIn(one.channel.name, {"nsec", "nsecs", "nanosec", "nanosecs"});
  });
  if (seconds != table.columns.end() && nanos != table.columns.end()) return joinColumns(table, seconds, nanos);
  joinNamelessStamps(table);
}

}  // namespace breakaway
