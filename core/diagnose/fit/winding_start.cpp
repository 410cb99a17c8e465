#include "diagnose/fit/winding_start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace breakaway {

namespace {

constexpr double farOff = 2.0, inductanceFarOff = 5.0;  ///< times what is seen, or a part of it
constexpr double shortest_s = 2e-5, lag = 1.3;          ///< of the time constants that are tried, and their ratio
constexpr int lags = 32;                                ///< up to 70 ms
constexpr double usual_s[]{3e-4, 1e-3, 3e-3};           ///< time constants of windings
constexpr size_t mostRows = 40'000;

/// i = lag(u)/R − lag(ω) Ke/R over one track, its products added up.
struct Balance {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();  ///< of lagged voltage, lagged speed and current

  void add(const Track& track, double time_s) {
    double u = track.input.front(), speed = track.motion.velocity.front();
    for (size_t k = 0; k + 1 < std::min(track.rows(), mostRows); ++k) {
      if (track.connected[k] != 0 && std::isfinite(track.current[k])) {
        const Eigen::Vector3d row(u, speed, track.current[k]);
        products += row * row.transpose();
      }
      const double keep = std::exp(-(track.time[k + 1] - track.time[k]) / time_s);
      u = track.input[k] + (u - track.input[k]) * keep;
      speed = track.motion.velocity[k] + (speed - track.motion.velocity[k]) * keep;
    }
  }
  Eigen::Vector2d solution() const {
    return products.topLeftCorner<2, 2>().ldlt().solve(products.topRightCorner<2, 1>());
  }
  double left() const { return products(2, 2) - solution().dot(products.topRightCorner<2, 1>()); }
};

struct Winding {
  double resistance_ohm = 0.0, inductance_H = 0.0, backEmf = 0.0;
};

/// From the voltage balance; nothing where it makes no sense.
std::optional<Winding> windingOf(const std::vector<Track>& tracks) {
  double best = 1e300, time_s = shortest_s;
  std::optional<Winding> winding;
  for (int k = 0; k < lags; ++k, time_s *= lag) {
    Balance balance;
    for (const Track& track : tracks) balance.add(track, time_s);
    const Eigen::Vector2d perVolt = balance.solution();
    const double left = balance.left();
    if (!(left < best) || !(perVolt[0] > 0.0) || !(perVolt[1] < 0.0)) continue;
    best = left;
    winding = {1.0 / perVolt[0], time_s / perVolt[0], -perVolt[1] / perVolt[0]};
  }
  return winding;
}

bool isFarOff(const std::optional<double>& believed, double seen, double by) {
  return !believed || *believed > by * seen || *believed < seen / by;
}

/// With what the current shows in the place of what isn't trusted. The torque constant keeps its ratio to the back-EMF
/// constant.
Bench withWinding(Bench bench, const Winding& seen) {
  const MotorNames& names = motorNames(bench.axis);
  MotorBelief& motor = bench.motor;
  const auto trusts = [&bench](const char* name) { return bench.trusted.count(name) > 0; };
  if (!trusts(names.resistance)) motor.resistance_ohm = seen.resistance_ohm;
  if (!trusts(names.inductance)) motor.inductance_H = seen.inductance_H;
  if (trusts(names.backEmfConstant)) return bench;
  const double before = motor.backEmfConstant.value_or(motor.torqueConstant.value_or(seen.backEmf));
  if (!trusts(names.torqueConstant))
    motor.torqueConstant = motor.torqueConstant.value_or(before) * seen.backEmf / before;
  motor.backEmfConstant = seen.backEmf;
  return bench;
}

}  // namespace

StartingWindings startingWindings(const Bench& bench, const std::vector<Track>& tracks) {
  if (!bench.electrical()) return {{bench}, {}};
  const bool currentSeen =
      std::all_of(tracks.begin(), tracks.end(), [](const Track& one) { return !one.current.empty(); });
  const MotorBelief& motor = bench.motor;
  if (currentSeen) {
    const auto seen = windingOf(tracks);
    if (!seen) return {{bench}, {}};
    const bool off =
        isFarOff(motor.resistance_ohm, seen->resistance_ohm, farOff) ||
        isFarOff(motor.inductance_H, seen->inductance_H, inductanceFarOff) ||
        isFarOff(motor.backEmfConstant ? motor.backEmfConstant : motor.torqueConstant, seen->backEmf, farOff);
    return {{off ? withWinding(bench, *seen) : bench}, seen->inductance_H};
  }
  std::vector<Bench> benches{bench};
  if (motor.inductance_H) return {benches, {}};
  for (const double time_s : usual_s) {
    benches.push_back(bench);
    benches.back().motor.inductance_H = time_s * motor.resistance_ohm.value_or(1.0);
  }
  return {benches, {}};
}

}  // namespace breakaway
