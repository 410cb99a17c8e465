#include "identify/map_estimation.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "identify/breakaway_trend.h"
#include "identify/map_filling.h"

namespace breakaway {

namespace {

constexpr size_t leastEvents = 8;
constexpr size_t binsPerWave = 3;  // at least, of what moving friction shows

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Measured over commanded current, pooled; 1 when the ramps say nothing.
double pooledSlope(const std::vector<BreakawayEvent>& events, double noiseRms_A) {
  double xx = 0.0, xy = 0.0;
  for (const BreakawayEvent& event : events) {
    xx += event.commandedVariance_A2 * static_cast<double>(event.samples);
    xy += event.covariance_A2 * static_cast<double>(event.samples);
  }
  if (!(xx > 0.0)) return 1.0;
  const double variance = noiseRms_A * noiseRms_A / xx;
  // Drawn towards one as far as the noise leaves it open, with a prior of 10 %.
  const double trust = 0.01 / (0.01 + variance);
  return 1.0 + trust * (xy / xx - 1.0);
}

/// How many neighbours bring the offset's noise down to the aim.
size_t neighboursNeeded(const std::vector<const BreakawayEvent*>& events, const MapOptions& options) {
  std::vector<double> currents, counts;
  for (const BreakawayEvent* event : events) {
    currents.push_back(std::abs(event->current_A));
    counts.push_back(static_cast<double>(event->samples));
  }
  const double aim = options.calibration * median(currents), count = std::max(1.0, median(counts));
  if (!(aim > 0.0)) return events.size();
  const double needed = std::ceil(options.noiseRms_A * options.noiseRms_A / (aim * aim) / count);
  return static_cast<size_t>(std::clamp(needed, 1.0, static_cast<double>(events.size())));
}

/// Values at the bin centres by interpolation over the angle, around the turn; `points` sorted by angle, not empty.
std::vector<double> interpolated(const std::vector<std::pair<double, double>>& points, size_t bins) {
  std::vector<double> values(bins);
  for (size_t k = 0; k < bins; ++k) {
    const double angle = (static_cast<double>(k) + 0.5) * turn_rad / static_cast<double>(bins);
    const auto after = std::lower_bound(points.begin(), points.end(), std::make_pair(angle, -1e300));
    const auto& high = after == points.end() ? points.front() : *after;
    const auto& low = after == points.begin() ? points.back() : *(after - 1);
    double width = high.first - low.first, part = angle - low.first;
    if (width <= 0.0) width += turn_rad;
    if (part < 0.0) part += turn_rad;
    values[k] = width > 1e-12 ? low.second + (high.second - low.second) * std::min(1.0, part / width) : low.second;
  }
  return values;
}

/// Straight lines between breakaways would cut off what fine cogging does between them, so they are drawn between what
/// is left over the curve that the breakaways of all turns follow.
std::vector<std::vector<double>> turnsOf(const std::vector<BreakawayEvent>& events, Way way,
                                         const BreakawayTrend& trend, const MapOptions& options) {
  std::vector<std::vector<double>> turns;
  for (size_t turn = 0; turn < options.turns; ++turn) {
    std::vector<std::pair<double, double>> points;
    for (const BreakawayEvent& event : events) {
      if (event.way == way && event.turn == turn)
        points.emplace_back(event.angle_rad, event.torque_Nm - trend.torqueAt_Nm(event.angle_rad));
    }
    if (points.size() < leastEvents) continue;
    std::sort(points.begin(), points.end());
    turns.push_back(interpolated(points, options.bins));
    for (size_t k = 0; k < options.bins; ++k)
      turns.back()[k] +=
          trend.torqueAt_Nm((static_cast<double>(k) + 0.5) * turn_rad / static_cast<double>(options.bins));
  }
  return turns;
}
}  // namespace

std::vector<BreakawayEvent> calibrated(std::vector<BreakawayEvent> events, const MapOptions& options) {
  const double slope = pooledSlope(events, options.noiseRms_A);
  for (const Way way : {Way::cw, Way::ccw}) {
    std::vector<const BreakawayEvent*> same;
    for (const BreakawayEvent& event : events) {
      if (event.way == way) same.push_back(&event);
    }
    if (same.empty()) continue;
    const size_t needed = neighboursNeeded(same, options), n = same.size();
    std::vector<double> offsets, weights;
    for (const BreakawayEvent* event : same) {
      offsets.push_back(event->measuredMean_A - slope * event->commandedMean_A);
      weights.push_back(static_cast<double>(event->samples));
    }
    size_t k = 0;
    for (BreakawayEvent& event : events) {
      if (event.way != way) continue;
      const size_t first = std::min(k > needed / 2 ? k - needed / 2 : 0, n - std::min(n, needed));
      double sum = 0.0, weight = 0.0;
      for (size_t j = first; j < std::min(n, first + needed); ++j) sum += weights[j] * offsets[j], weight += weights[j];
      event.current_A = slope * event.commanded_A + (weight > 0.0 ? sum / weight : offsets[k]);
      event.torque_Nm = options.torqueConstant_Nm_per_A * event.current_A;
      ++k;
    }
  }
  return events;
}

Result<FrictionMap> estimateMap(const std::vector<BreakawayEvent>& measured,
                                const std::array<MovingFriction, 2>* moving, const MapOptions& options) {
  const std::vector<BreakawayEvent> events = calibrated(measured, options);
  FrictionMap map;
  map.rig = options.rig;
  map.turns = options.turns;
  map.totalVelocity_rad_per_s = options.totalVelocity_rad_per_s;
  map.bins.resize(options.bins);
  for (size_t k = 0; k < options.bins; ++k) {
    map.bins[k].angle_rad = (static_cast<double>(k) + 0.5) * turn_rad / static_cast<double>(options.bins);
  }
  std::array<double, 2> finer_Nm2{};
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto w = static_cast<size_t>(way);
    const BreakawayTrend trend(events, way);
    finer_Nm2[w] = trend.finerThan_Nm2(options.bins / binsPerWave);
    map.turnStatic_Nm[w] = turnsOf(events, way, trend, options);
    if (map.turnStatic_Nm[w].empty()) {
      return Error{std::string("breakaway sweep, ") + (way == Way::cw ? "cw" : "ccw"),
                   message("has fewer than 8 breakaways in each turn")};
    }
    const auto binOf = [&map](const BreakawayEvent& event) {
      return static_cast<size_t>(event.angle_rad / turn_rad * static_cast<double>(map.bins.size()));
    };
    fillStatic(map, way, events, binOf, commonError(measured, way, options), options.scaleError);
    for (MapBin& bin : map.bins) {
      double& error = bin.way[w].static_Nm.standardError;
      error = std::hypot(error, options.angleError_rad * trend.slopeAt_Nm_per_rad(bin.angle_rad),
                         trend.errorAt_Nm(bin.angle_rad));
    }
  }
  if (moving != nullptr) {
    auto ways = *moving;
    widenCoulomb(ways, finer_Nm2);
    fillMoving(map, ways);
  }
  return map;
}

}  // namespace breakaway
