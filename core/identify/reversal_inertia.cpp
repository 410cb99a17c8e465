#include "identify/reversal_inertia.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace breakaway {

namespace {

constexpr double slowest = 0.2, fastest = 0.65;  // part of the highest speed that slopes are taken over
constexpr size_t leastBlocks = 4, leastReversals = 3;

struct Point {
  double time_s = 0.0, speed_rad_per_s = 0.0, current_A = 0.0;
};

struct Slope {
  double acceleration = 0.0, current_A = 0.0;
};

/// Of the points whose speed has the way's sign and lies in the range, from `at` on in the given direction of time.
std::optional<Slope> slopeFrom(const std::vector<Point>& points, size_t at, bool onward, double way, double highest) {
  double n = 0.0, t = 0.0, v = 0.0, tt = 0.0, tv = 0.0, i = 0.0;
  const double begin_s = points[at].time_s;
  for (size_t k = at; k < points.size(); onward ? ++k : --k) {
    const double speed = way * points[k].speed_rad_per_s;
    if (speed > fastest * highest) break;
    if (speed >= slowest * highest) {
      const double since = points[k].time_s - begin_s;
      n += 1.0, t += since, v += points[k].speed_rad_per_s, tt += since * since;
      tv += since * points[k].speed_rad_per_s, i += points[k].current_A;
    }
    if (!onward && k == 0) break;
  }
  if (n < static_cast<double>(leastBlocks)) return {};
  return Slope{(n * tv - t * v) / (n * tt - t * t), i / n};
}

}  // namespace

Result<Estimate> reversalInertia(const std::vector<SpinBlock>& blocks, const ReversalOptions& options) {
  std::vector<Point> points;
  double highest = 0.0;
  for (size_t k = 1; k < blocks.size(); ++k) {
    const double speed = (blocks[k].angle_rad - blocks[k - 1].angle_rad) / blocks[k].duration_s;
    points.push_back({blocks[k].end_s - 0.5 * blocks[k].duration_s, speed, blocks[k].current_A});
    highest = std::max(highest, std::abs(speed));
  }
  std::array<std::vector<double>, 2> inertias;  // by the way before the reversal
  double current = 0.0;
  for (size_t k = 1; k < points.size(); ++k) {
    const double before = points[k - 1].speed_rad_per_s, after = points[k].speed_rad_per_s;
    if (before == 0.0 || before * after > 0.0) continue;
    const double way = before > 0.0 ? 1.0 : -1.0;
    const auto braking = slopeFrom(points, k - 1, false, way, highest);
    const auto speeding = slopeFrom(points, k, true, -way, highest);
    if (!braking || !speeding) continue;
    const double slopes = -way * (braking->acceleration + speeding->acceleration);
    const double amps = -way * (braking->current_A + speeding->current_A);
    if (!(slopes > 0.0)) continue;
    inertias[way > 0.0 ? 0 : 1].push_back(options.torqueConstant_Nm_per_A * amps / slopes);
    current = std::max(current, 0.5 * amps);
  }
  Estimate inertia;
  for (const auto& one : inertias) {
    if (one.size() < leastReversals)
      return Error{"inertia by reversal", message("saw the rotor turn round {} times one way, expected at least {}",
                                                  one.size(), leastReversals)};
    double sum = 0.0, squares = 0.0;
    const auto n = static_cast<double>(one.size());
    for (const double value : one) sum += value / n;
    for (const double value : one) squares += (value - sum) * (value - sum);
    inertia.value += 0.5 * sum;
    inertia.standardError = std::hypot(inertia.standardError, 0.5 * std::sqrt(squares / (n * (n - 1.0))));
  }
  if (current < 0.8 * options.commanded_A) {
    return Error{"inertia by reversal",
                 message("was asked for with {:.3g} A, but the current reached {:.3g} A only: it is saturated",
                         options.commanded_A, current)};
  }
  return inertia;
}

}  // namespace breakaway
