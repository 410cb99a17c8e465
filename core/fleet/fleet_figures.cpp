#include "fleet/fleet_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr double drawnDeviations = 8.0;
constexpr double fewestBins = 8.0, mostBins = 40.0;
constexpr double mostDates = 40.0;

/// The values' range, as far as it is drawn.
std::pair<double, double> drawnRange(const FleetColumn& column) {
  double low = column.values.front().value, high = low;
  for (const FleetValue& one : column.values) {
    low = std::min(low, one.value);
    high = std::max(high, one.value);
  }
  if (!(column.deviation > 0.0)) return {low, high};
  return {std::max(low, column.median - drawnDeviations * column.deviation),
          std::min(high, column.median + drawnDeviations * column.deviation)};
}

/// Freedman and Diaconis, "On the histogram as a density estimator", 1981.
size_t binsOf(const FleetColumn& column, double range) {
  const double width =
      2.0 * (column.quantileOf(0.75) - column.quantileOf(0.25)) / std::cbrt(static_cast<double>(column.values.size()));
  return static_cast<size_t>(width > 0.0 ? std::clamp(std::ceil(range / width), fewestBins, mostBins) : fewestBins);
}

/// A bar of its own: up, along, down, and a gap, which parts what is filled from the next one's.
void addBar(Curve& bars, double from, double width, double height) {
  for (const auto& [x, y] : {std::pair(from, 0.0),
                             {from, height},
                             {from + width, height},
                             {from + width, 0.0},
                             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()}}) {
    bars.x.push_back(x);
    bars.y.push_back(y);
    bars.low.push_back(0.0);
    bars.high.push_back(height);
  }
}

/// What lies where on the axis of dates.
struct Dated {
  double day = 0.0, value = 0.0;
};

}  // namespace

size_t beyondSpread(const FleetColumn& column) {
  const auto [low, high] = drawnRange(column);
  return static_cast<size_t>(
      std::count_if(column.values.begin(), column.values.end(),
                    [low = low, high = high](const FleetValue& one) { return one.value < low || one.value > high; }));
}

Figure spreadFigure(const FleetColumn& column) {
  const auto [low, high] = drawnRange(column);
  const double range = high - low;
  const size_t bins = range > 0.0 ? binsOf(column, range) : 1;
  const double width = range > 0.0 ? range / static_cast<double>(bins) : std::max(std::abs(low), 1e-12) * 0.1;
  const double from = range > 0.0 ? low : low - 0.5 * width;
  std::vector<double> counts(bins, 0.0);
  Curve bars, apart;
  bars.colour = 0;
  apart.label = "stand out";
  apart.colour = 1;
  apart.style = Curve::Style::points;
  apart.width_px = 2.5;
  for (const FleetValue& one : column.values) {
    if (one.value < low || one.value > high) continue;
    counts[std::min(static_cast<size_t>((one.value - from) / width), bins - 1)] += 1.0;
    if (std::abs(column.distance(one)) < standsOutFrom) continue;
    apart.x.push_back(one.value);
    apart.y.push_back(0.0);
  }
  for (size_t k = 0; k < bins; ++k) addBar(bars, from + width * static_cast<double>(k), width, counts[k]);
  Figure figure{.title = column.name, .xLabel = column.name, .yLabel = "entries", .curves = {std::move(bars)}};
  if (!apart.x.empty()) figure.curves.push_back(std::move(apart));
  return figure;
}

std::optional<Figure> trendFigure(const FleetColumn& column, const std::vector<FleetEntry>& entries) {
  std::vector<Dated> dated;
  for (size_t k = 0; k < column.entries.size(); ++k) {
    if (const auto day = daysOf(entries[column.entries[k]].at)) dated.push_back({*day, column.values[k].value});
  }
  if (dated.empty()) return {};
  const auto [first, last] =
      std::minmax_element(dated.begin(), dated.end(), [](const Dated& a, const Dated& b) { return a.day < b.day; });
  const double begin = std::floor(first->day), days = std::floor(last->day) - begin + 1.0;
  if (days < 2.0) return {};
  const double width = std::max(1.0, std::ceil(days / mostDates));  // whole days
  std::map<size_t, std::vector<Dated>> groups;
  for (const Dated& one : dated) groups[static_cast<size_t>((one.day - begin) / width)].push_back(one);
  Curve curve, points;
  curve.label = "median";
  curve.colour = points.colour = 0;
  points.style = Curve::Style::points;
  points.width_px = 2.0;
  for (const auto& [group, ones] : groups) {
    std::vector<double> values, when;
    values.reserve(ones.size());
    when.reserve(ones.size());
    for (const Dated& one : ones) {
      values.push_back(one.value);
      when.push_back(one.day - begin);
    }
    curve.x.push_back(mean(when));
    curve.y.push_back(quantile(values, 0.5));
    curve.low.push_back(quantile(values, 0.25));
    curve.high.push_back(quantile(values, 0.75));
  }
  points.x = curve.x;
  points.y = curve.y;
  return Figure{.title = column.name,
                .xLabel = "days since the first date",
                .yLabel = column.name,
                .curves = {std::move(curve), std::move(points)}};
}

}  // namespace breakaway
