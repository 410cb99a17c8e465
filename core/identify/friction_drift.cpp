#include "identify/friction_drift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr double usualDrift = 0.05;
constexpr size_t fewestAgain = 8;  ///< breakaways at a place that had one before, a way

/// Torque over time beside a torque of its own at each place.
std::optional<Estimate> slopeOf(const std::vector<BreakawayEvent>& events, Way way) {
  std::map<size_t, std::vector<const BreakawayEvent*>> places;
  for (const BreakawayEvent& event : events) {
    if (event.way == way && !event.outlier) places[event.bin].push_back(&event);
  }
  std::vector<std::pair<double, double>> apart;  // time and torque, from the place's means
  size_t again = 0;
  for (const auto& [bin, here] : places) {
    const auto count = static_cast<double>(here.size());
    double time_s = 0.0, torque_Nm = 0.0;
    for (const BreakawayEvent* one : here) time_s += one->time_s / count, torque_Nm += one->torque_Nm / count;
    for (const BreakawayEvent* one : here) apart.emplace_back(one->time_s - time_s, one->torque_Nm - torque_Nm);
    again += here.size() - 1;
  }
  double xx = 0.0, xy = 0.0, squares = 0.0;
  for (const auto& [x, y] : apart) xx += x * x, xy += x * y;
  if (again < fewestAgain || !(xx > 0.0)) return std::nullopt;
  const double slope = xy / xx;
  for (const auto& [x, y] : apart) squares += (y - slope * x) * (y - slope * x);
  return Estimate{slope, std::sqrt(squares / static_cast<double>(again - 1) / xx)};
}

}  // namespace

std::optional<FrictionDrift> frictionDrift(const std::vector<BreakawayEvent>& events) {
  const auto cw = slopeOf(events, Way::cw), ccw = slopeOf(events, Way::ccw);
  if (!cw || !ccw) return std::nullopt;
  const auto [first, last] = std::minmax_element(
      events.begin(), events.end(),
      [](const BreakawayEvent& one, const BreakawayEvent& other) { return one.time_s < other.time_s; });
  std::array<std::vector<double>, 2> torques_Nm;
  for (const BreakawayEvent& event : events) torques_Nm[event.way == Way::cw ? 0 : 1].push_back(event.torque_Nm);
  const double friction_Nm = 0.5 * (mean(torques_Nm[0]) + mean(torques_Nm[1]));
  if (!(friction_Nm > 0.0)) return std::nullopt;
  FrictionDrift drift;
  drift.duration_s = last->time_s - first->time_s;
  const double toPart = drift.duration_s / friction_Nm;
  drift.part = {toPart * 0.5 * (cw->value + ccw->value),
                std::abs(toPart) * 0.5 * std::hypot(cw->standardError, ccw->standardError)};
  return drift;
}

std::optional<Message> wordsOf(const FrictionDrift& drift) {
  const Estimate& part = drift.part;
  const bool fell = part.high95() < -usualDrift;
  if (!fell && part.low95() <= usualDrift) return std::nullopt;
  const double least = 100.0 * std::min(std::abs(part.low95()), std::abs(part.high95())),
               most = 100.0 * std::max(std::abs(part.low95()), std::abs(part.high95()));
  return fell ? message(
                    "What starts motion fell by {:.0f} % ({:.0f} to {:.0f} %) over the {:.0f} s of its measuring, "
                    "as in an axis that wasn't warm: let it run for as long, and measure again.",
                    100.0 * std::abs(part.value), least, most, drift.duration_s)
              : message(
                    "What starts motion rose by {:.0f} % ({:.0f} to {:.0f} %) over the {:.0f} s of its measuring: "
                    "something tightens as it warms, or dirt gets in; the map is of the time between.",
                    100.0 * part.value, least, most, drift.duration_s);
}

}  // namespace breakaway
