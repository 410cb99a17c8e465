// Two friction maps bin by bin.
#include <algorithm>
#include <cmath>

#include "report/map_figures.h"
#include "report/run_comparison.h"

namespace breakaway {

namespace {

struct MapQuantity {
  MessageText<0> name;
  Estimate WayBin::*of;
};
constexpr MapQuantity quantities[] = {{"static", &WayBin::static_Nm}, {"Coulomb", &WayBin::coulomb_Nm}};

/// The bin of `map` that a place lies in: maps need not have the same number of them.
const MapBin& binAt(const FrictionMap& map, double place) {
  const size_t count = map.bins.size();
  if (count == 1) return map.bins.front();
  const double width = map.bins[1].angle_rad - map.bins[0].angle_rad;
  const double number = std::floor((place - map.bins.front().angle_rad) / width + 0.5);
  const double last = static_cast<double>(count) - 1.0;
  if (map.axis == Axis::linear) return map.bins[static_cast<size_t>(std::clamp(number, 0.0, last))];
  const double within = std::fmod(std::fmod(number, last + 1.0) + last + 1.0, last + 1.0);
  return map.bins[static_cast<size_t>(within)];
}

Estimate difference(const Estimate& before, const Estimate& after) {
  return {after.value - before.value, std::hypot(after.standardError, before.standardError)};
}

bool isFrom(const Estimate& difference) {
  return difference.standardError > 0.0 && std::abs(difference.value) > normal95 * difference.standardError;
}

MapChange changeOf(const FrictionMap& before, const FrictionMap& after, const MapQuantity& quantity, size_t way) {
  MapChange change;
  change.quantity = message(quantity.name) + ", " + message(mapUnitsOf(after.axis).ways[way]);
  double sum = 0.0, variance = 0.0;
  for (const MapBin& bin : after.bins) {
    const Estimate d = difference(binAt(before, bin.angle_rad).way[way].*quantity.of, bin.way[way].*quantity.of);
    ++change.bins;
    if (d.standardError > 0.0) change.byChance += 0.05;
    if (isFrom(d)) ++change.beyond;
    sum += d.value;
    variance += d.standardError * d.standardError;
    if (std::abs(d.value) > std::abs(change.largest)) {
      change.largest = d.value;
      change.largestAt = bin.angle_rad;
    }
  }
  const auto count = static_cast<double>(change.bins);
  change.meanDifference = sum / count;
  change.meanHalfWidth = normal95 * std::sqrt(variance / count);
  return change;
}

Curve staticCurve(const FrictionMap& map, size_t way) {
  const MapUnits& units = mapUnitsOf(map.axis);
  const double placeScale = map.axis == Axis::rotary ? 1.0 : units.placeScale;
  Curve curve;
  curve.colour = wayColour(way);
  for (const MapBin& bin : map.bins) {
    curve.x.push_back(placeScale * bin.angle_rad);
    curve.y.push_back(units.torqueScale * bin.way[way].static_Nm.value);
  }
  return curve;
}

double largestOf(const FrictionMap& map) {
  double most = 0.0;
  for (const MapBin& bin : map.bins)
    for (const WayBin& way : bin.way) most = std::max(most, std::abs(way.static_Nm.value));
  return most * mapUnitsOf(map.axis).torqueScale;
}

void addRing(const FrictionMap& before, const FrictionMap& after, Figure& figure) {
  const double scale = mapUnitsOf(after.axis).torqueScale;
  const double outside = 1.3 * std::max(largestOf(before), largestOf(after));
  Curve ring, base;
  base.label = message("no difference");
  base.style = Curve::Style::dashed;
  base.colour = 6;
  base.width_px = 1.0;
  ring.label = message("ring: after − before, mean of both ways, same scale");
  ring.colour = 2;
  for (const Estimate& d : meanDifference(before, after)) {
    ring.x.push_back(after.bins[ring.x.size()].angle_rad);
    ring.y.push_back(outside + scale * d.value);
    ring.low.push_back(outside + scale * d.low95());
    ring.high.push_back(outside + scale * d.high95());
    base.x.push_back(ring.x.back());
    base.y.push_back(outside);
  }
  figure.curves.push_back(std::move(base));
  figure.curves.push_back(std::move(ring));
}

}  // namespace

bool MapChange::isBeyond() const {
  const double tooMany = byChance + 3.0 * std::sqrt(byChance);
  return (meanHalfWidth > 0.0 && std::abs(meanDifference) > meanHalfWidth) ||
         (byChance > 0.0 && static_cast<double>(beyond) > tooMany);
}

std::vector<Estimate> meanDifference(const FrictionMap& before, const FrictionMap& after, Estimate WayBin::*quantity) {
  std::vector<Estimate> differences;
  if (before.axis != after.axis || before.bins.empty()) return differences;
  differences.reserve(after.bins.size());
  for (const MapBin& bin : after.bins) {
    const MapBin& earlier = binAt(before, bin.angle_rad);
    const Estimate cw = difference(earlier.way[0].*quantity, bin.way[0].*quantity);
    const Estimate ccw = difference(earlier.way[1].*quantity, bin.way[1].*quantity);
    differences.push_back({0.5 * (cw.value + ccw.value), 0.5 * std::hypot(cw.standardError, ccw.standardError)});
  }
  return differences;
}

std::vector<MapChange> compareMaps(const FrictionMap& before, const FrictionMap& after) {
  std::vector<MapChange> changes;
  if (before.axis != after.axis || before.bins.empty() || after.bins.empty()) return changes;
  for (const MapQuantity& quantity : quantities)
    for (size_t way = 0; way < 2; ++way) changes.push_back(changeOf(before, after, quantity, way));
  return changes;
}

Figure ghostFigure(const FrictionMap& before, const FrictionMap& after) {
  const MapUnits& units = mapUnitsOf(after.axis);
  const bool around = after.axis == Axis::rotary;
  Figure figure{message("Static {}, earlier dashed", message(units.torque)), around ? Message() : message(units.place),
                units.torqueTitle()};
  figure.polar = around;
  for (size_t way = 0; way < 2; ++way) {
    Curve ghost = staticCurve(before, way), now = staticCurve(after, way);
    ghost.label = message("earlier, {}", message(units.ways[way]));
    ghost.style = Curve::Style::dashed;
    ghost.width_px = 1.1;
    now.label = message(units.ways[way]);
    for (const MapBin& bin : after.bins) {
      now.low.push_back(units.torqueScale * bin.way[way].static_Nm.low95());
      now.high.push_back(units.torqueScale * bin.way[way].static_Nm.high95());
    }
    figure.curves.push_back(std::move(ghost));
    figure.curves.push_back(std::move(now));
  }
  if (around) addRing(before, after, figure);
  return figure;
}

Figure differenceFigure(const FrictionMap& before, const FrictionMap& after) {
  const MapUnits& units = mapUnitsOf(after.axis);
  Figure figure{message("Static {}, after − before", message(units.torque)), message(units.place), units.torqueTitle()};
  for (size_t way = 0; way < 2; ++way) {
    Curve curve;
    curve.label = message(units.ways[way]);
    curve.colour = wayColour(way);
    for (const MapBin& bin : after.bins) {
      const Estimate d = difference(binAt(before, bin.angle_rad).way[way].static_Nm, bin.way[way].static_Nm);
      curve.x.push_back(units.placeScale * bin.angle_rad);
      curve.y.push_back(units.torqueScale * d.value);
      curve.low.push_back(units.torqueScale * d.low95());
      curve.high.push_back(units.torqueScale * d.high95());
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

}  // namespace breakaway
