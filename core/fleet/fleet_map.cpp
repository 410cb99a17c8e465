#include "fleet/fleet_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr size_t mapPlaces = 120;  ///< around the turn, whatever bins a map has

double placeOf(size_t k) {
  return turn_rad * static_cast<double>(k) / static_cast<double>(mapPlaces);
}

/// A quantity of the bins at each place, by straight lines between bins.
template <typename ValueOf>
std::vector<double> aroundTurn(const FrictionMap& map, const ValueOf& valueOf) {
  const auto count = static_cast<double>(map.bins.size());
  std::vector<double> curve;
  curve.reserve(mapPlaces);
  for (size_t k = 0; k < mapPlaces; ++k) {
    const double turns = (placeOf(k) - map.bins.front().angle_rad) / turn_rad;
    const double at = (turns - std::floor(turns)) * count, from = std::floor(at);
    const auto bin = static_cast<size_t>(from) % map.bins.size();
    const double value = valueOf(map.bins[bin]), next = valueOf(map.bins[(bin + 1) % map.bins.size()]);
    curve.push_back(value + (at - from) * (next - value));
  }
  return curve;
}

FleetValue withInterval(const Estimate& estimate) {
  return {estimate.value, estimate.low95(), estimate.high95()};
}

/// Median and middle half of all maps at each place.
Curve overFleet(const std::vector<FleetEntry>& entries, std::vector<double> MapCurves::*of, const char* label,
                int colour) {
  Curve curve;
  curve.label = label;
  curve.colour = colour;
  for (size_t k = 0; k <= mapPlaces; ++k) {
    std::vector<double> values;
    for (const FleetEntry& entry : entries) {
      if (entry.map) values.push_back(((*entry.map).*of)[k % mapPlaces]);
    }
    curve.x.push_back(360.0 * static_cast<double>(k) / static_cast<double>(mapPlaces));
    curve.low.push_back(quantile(values, 0.25));
    curve.high.push_back(quantile(values, 0.75));
    curve.y.push_back(quantile(std::move(values), 0.5));
  }
  return curve;
}

}  // namespace

void addMap(FleetEntry& entry, const FrictionMap& map) {
  if (map.bins.empty()) return;
  double friction_Nm = 0.0;
  std::vector<double> position_Nm;
  position_Nm.reserve(map.bins.size());
  for (const MapBin& bin : map.bins) {
    friction_Nm += bin.staticFriction_Nm() / static_cast<double>(map.bins.size());
    position_Nm.push_back(bin.positionTorque_Nm());
  }
  const auto [low, high] = std::minmax_element(position_Nm.begin(), position_Nm.end());
  const double swing_Nm = 0.5 * (*high - *low);
  const auto add = [&](const char* name, const FleetValue& value) {
    entry.parameters.emplace_back(nameOn(map.axis, name), value);
  };
  add("map_static_friction_Nm", {friction_Nm, friction_Nm, friction_Nm});
  add("map_position_torque_Nm", {swing_Nm, swing_Nm, swing_Nm});
  add("map_coulomb_Nm", withInterval(map.coulombAverage_Nm));
  add("map_viscous_Nm_s_per_rad", withInterval(map.viscousAverage_Nm_s_per_rad));
  if (map.axis != Axis::rotary) return;
  MapCurves curves;
  curves.staticCw_Nm = aroundTurn(map, [](const MapBin& bin) { return bin.way[0].static_Nm.value; });
  curves.staticCcw_Nm = aroundTurn(map, [](const MapBin& bin) { return bin.way[1].static_Nm.value; });
  curves.coulombCw_Nm = aroundTurn(map, [](const MapBin& bin) { return bin.way[0].coulomb_Nm.value; });
  curves.coulombCcw_Nm = aroundTurn(map, [](const MapBin& bin) { return bin.way[1].coulomb_Nm.value; });
  curves.position_Nm = aroundTurn(map, [](const MapBin& bin) { return bin.positionTorque_Nm(); });
  entry.map = std::move(curves);
}

std::vector<Figure> mapFigures(const std::vector<FleetEntry>& entries) {
  if (std::count_if(entries.begin(), entries.end(), [](const FleetEntry& one) { return one.map.has_value(); }) < 2)
    return {};
  const auto figure = [](const char* title, std::vector<Curve> curves) {
    return Figure{
        .title = title, .xLabel = "angle from the index / °", .yLabel = "torque / Nm", .curves = std::move(curves)};
  };
  return {figure("Static friction", {overFleet(entries, &MapCurves::staticCw_Nm, "cw", 0),
                                     overFleet(entries, &MapCurves::staticCcw_Nm, "ccw", 1)}),
          figure("What keeps it moving", {overFleet(entries, &MapCurves::coulombCw_Nm, "cw", 0),
                                          overFleet(entries, &MapCurves::coulombCcw_Nm, "ccw", 1)}),
          figure("Position torque", {overFleet(entries, &MapCurves::position_Nm, "", 0)})};
}

}  // namespace breakaway
