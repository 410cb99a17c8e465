#include "identify/travel_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "identify/breakaway_trend.h"
#include "identify/map_filling.h"

namespace breakaway {

namespace {

constexpr size_t leastTravelEvents = 8;
constexpr double coursePart = 0.9;     // of a turn, that the travel is laid on: its ends don't meet
constexpr double binsPerPeriod = 3.0;  // at least, of what moving friction shows

/// Mean square of the waves over the travel that are too fine for its bins.
double finerThanBins_N2(std::vector<BreakawayEvent> events, Way way, const TravelBins& bins) {
  const double count = static_cast<double>(bins.count), length_m = count * bins.width_m();
  for (BreakawayEvent& event : events)
    event.angle_rad = coursePart * turn_rad * (event.angle_rad - bins.from_m) / length_m;
  return BreakawayTrend(events, way).finerThan_Nm2(static_cast<size_t>(count / binsPerPeriod / coursePart));
}

/// Straight between points that are sorted by place, level beyond their ends.
double between(const std::vector<std::pair<double, double>>& points, double place) {
  const auto after = std::lower_bound(points.begin(), points.end(), std::make_pair(place, -1e300));
  if (after == points.begin()) return after->second;
  const auto& low = *(after - 1);
  if (after == points.end()) return low.second;
  const double width = after->first - low.first;
  return width > 0.0 ? low.second + (after->second - low.second) * (place - low.first) / width : low.second;
}

}  // namespace

Result<FrictionMap> estimateTravelMap(const std::vector<BreakawayEvent>& measured,
                                      const std::array<MovingFriction, 2>& moving, const TravelBins& bins,
                                      double index_m, const MapOptions& options) {
  const std::vector<BreakawayEvent> events = calibrated(measured, options);
  FrictionMap map;
  map.axis = Axis::linear;
  map.rig = options.rig;
  map.turns = options.turns;
  map.totalVelocity_rad_per_s = options.totalVelocity_rad_per_s;
  map.bins.resize(bins.count);
  for (size_t k = 0; k < bins.count; ++k) map.bins[k].angle_rad = bins.centre_m(k) - index_m;
  auto ways = moving;
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto w = static_cast<size_t>(way);
    std::vector<std::pair<double, double>> trend;
    trend.reserve(bins.count);
    for (size_t k = 0; k < bins.count; ++k) trend.emplace_back(bins.centre_m(k), moving[w].coulomb_Nm[k].value);
    for (size_t turn = 0; turn < options.turns; ++turn) {
      std::vector<std::pair<double, double>> over;
      for (const BreakawayEvent& event : events) {
        if (event.way == way && event.turn == turn)
          over.emplace_back(event.angle_rad, event.torque_Nm - between(trend, event.angle_rad));
      }
      if (over.size() < leastTravelEvents)
        return Error{std::string("breakaway sweep, ") + (way == Way::cw ? "backwards" : "forwards"),
                     message("has fewer than 8 breakaways in each pass")};
      std::sort(over.begin(), over.end());
      std::vector<double> values;
      values.reserve(trend.size());
      for (const auto& [centre, force] : trend) values.push_back(force + between(over, centre));
      map.turnStatic_Nm[w].push_back(std::move(values));
    }
    const auto binOf = [&bins](const BreakawayEvent& event) {
      return static_cast<size_t>(std::max(0.0, (event.angle_rad - bins.from_m) / bins.width_m()));
    };
    fillStatic(map, way, events, binOf, commonError(measured, way, options), options.scaleError);
  }
  widenCoulomb(ways, {finerThanBins_N2(events, Way::cw, bins), finerThanBins_N2(events, Way::ccw, bins)});
  fillMoving(map, ways);
  return map;
}

}  // namespace breakaway
