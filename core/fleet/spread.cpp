#include "fleet/spread.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "base/statistics.h"

namespace breakaway {

namespace {

/// How the names of numbers begin that come without an interval: wander_rms_Nm, map_static_friction_N, …
constexpr const char* withoutInterval[] = {"wander_", "map_static_", "map_position_"};

/// Columns in the order in which their names come.
class Columns {
 public:
  void add(const std::string& name, size_t entry, const FleetValue& value) {
    const auto [it, isNew] = places_.emplace(name, columns_.size());
    if (isNew) columns_.push_back({.name = name});
    columns_[it->second].entries.push_back(entry);
    columns_[it->second].values.push_back(value);
  }
  std::vector<FleetColumn> finish();

 private:
  std::map<std::string, size_t> places_;
  std::vector<FleetColumn> columns_;
};

/// The mean of the two in the middle, for an even number.
double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

void measure(FleetColumn& column) {
  column.intervals = std::none_of(std::begin(withoutInterval), std::end(withoutInterval),
                                  [&column](const char* name) { return column.name.starts_with(name); });
  std::vector<double> values;
  values.reserve(column.values.size());
  for (const FleetValue& one : column.values) values.push_back(one.value);
  column.median = medianOf(values);
  for (double& one : values) one = std::abs(one - column.median);
  const double middle = medianOf(values);
  column.deviation = middle > 0.0 ? 1.4826 * middle : 1.2533 * mean(values);
}

std::vector<FleetColumn> Columns::finish() {
  for (FleetColumn& column : columns_) measure(column);
  return std::move(columns_);
}

}  // namespace

double FleetColumn::quantileOf(double fraction) const {
  std::vector<double> all;
  all.reserve(values.size());
  for (const FleetValue& one : values) all.push_back(one.value);
  return quantile(std::move(all), fraction);
}

double FleetColumn::distance(const FleetValue& value) const {
  if (values.size() < fewestForOutliers || !(deviation > 0.0)) return 0.0;
  const double low = std::min(value.low95, value.value), high = std::max(value.high95, value.value);
  const double nearest = low > median ? low - median : high < median ? high - median : 0.0;
  return nearest / deviation;
}

std::vector<FleetColumn> baseColumns(const std::vector<FleetEntry>& entries) {
  Columns columns;
  for (size_t k = 0; k < entries.size(); ++k) {
    for (const auto& [name, value] : entries[k].parameters) columns.add(name, k, value);
  }
  return columns.finish();
}

std::vector<FleetColumn> findingColumns(const std::vector<FleetEntry>& entries) {
  Columns columns;
  for (size_t k = 0; k < entries.size(); ++k) {
    for (const FleetFinding& finding : entries[k].findings) {
      for (const auto& [name, value] : finding.parameters) columns.add(finding.effect + "." + name, k, value);
    }
  }
  return columns.finish();
}

std::vector<StandsOut> outliersFirst(const std::vector<FleetEntry>& entries, const std::vector<FleetColumn>& columns) {
  std::vector<StandsOut> order(entries.size());
  for (size_t k = 0; k < order.size(); ++k) order[k].entry = k;
  for (const FleetColumn& column : columns) {
    for (size_t k = 0; k < column.entries.size(); ++k) {
      if (!entries[column.entries[k]].error.empty()) continue;
      StandsOut& one = order[column.entries[k]];
      const double distance = column.distance(column.values[k]);
      if (std::abs(distance) <= std::abs(one.distance)) continue;
      one.parameter = column.name;
      one.distance = distance;
    }
  }
  std::stable_sort(order.begin(), order.end(), [&entries](const StandsOut& a, const StandsOut& b) {
    const bool failedA = !entries[a.entry].error.empty(), failedB = !entries[b.entry].error.empty();
    if (failedA != failedB) return failedB;
    return std::abs(a.distance) > std::abs(b.distance);
  });
  return order;
}

}  // namespace breakaway
