#include "identify/stribeck_velocity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace breakaway {

namespace {

constexpr double leastFall = 0.03;  // part of Coulomb friction
constexpr double leastError =
    0.05;  // of a turn's torque, part of the fall: the map's means and the shape are not exact
constexpr double lowest_rad_per_s = 0.05, highest_rad_per_s = 20.0, fineness = 1.01;
constexpr double mostRelativeError = 0.5;

struct Means {
  double static_Nm = 0.0, coulomb_Nm = 0.0, viscous = 0.0;
  double fall_Nm() const { return static_Nm - coulomb_Nm; }
};

Means meansOf(const FrictionMap& map, size_t way) {
  Means means;
  const auto n = static_cast<double>(map.bins.size());
  for (const MapBin& bin : map.bins) {
    means.static_Nm += bin.way[way].static_Nm.value / n;
    means.coulomb_Nm += bin.way[way].coulomb_Nm.value / n;
    means.viscous += bin.way[way].viscous_Nm_s_per_rad.value / n;
  }
  return means;
}

struct Fallen {
  double speed_rad_per_s, left;  ///< part of the fall that is left at this speed
};

double squaresAt(const std::vector<Fallen>& points, double stribeck) {
  double squares = 0.0;
  for (const Fallen& one : points) {
    const double x = one.speed_rad_per_s / stribeck;
    squares += std::pow(one.left - std::exp(-x * x), 2);
  }
  return squares;
}

}  // namespace

Estimate stribeckVelocity(const std::vector<SlowTurn>& turns, const FrictionMap& map, double torqueConstant_Nm_per_A) {
  if (map.bins.empty()) return {};
  const std::array<Means, 2> means{meansOf(map, 0), meansOf(map, 1)};
  std::vector<Fallen> points;
  for (const SlowTurn& turn : turns) {
    const double sign = turn.velocity_rad_per_s < 0.0 ? -1.0 : 1.0, speed = std::abs(turn.velocity_rad_per_s);
    const Means& way = means[sign < 0.0 ? 0 : 1];
    if (way.fall_Nm() < leastFall * way.coulomb_Nm) return {};
    const double dry_Nm = sign * torqueConstant_Nm_per_A * turn.current_A - way.viscous * speed;
    points.push_back({speed, (dry_Nm - way.coulomb_Nm) / way.fall_Nm()});
  }
  if (points.size() < 3) return {};
  double best = 0.0, least = 1e300;
  for (double speed = lowest_rad_per_s; speed < highest_rad_per_s; speed *= fineness) {
    const double squares = squaresAt(points, speed);
    if (squares < least) least = squares, best = speed;
  }
  if (best <= lowest_rad_per_s * fineness || best * fineness >= highest_rad_per_s) return {};
  // dg/dω_s = g·2x²/ω_s.
  double information = 0.0;
  for (const Fallen& one : points) {
    const double x = one.speed_rad_per_s / best;
    information += std::pow(std::exp(-x * x) * 2.0 * x * x / best, 2);
  }
  const double scatter = std::max(leastError, std::sqrt(least / (static_cast<double>(points.size()) - 1.0)));
  const double error = information > 0.0 ? scatter / std::sqrt(information) : best;
  return error < mostRelativeError * best ? Estimate{best, error} : Estimate{};
}

}  // namespace breakaway
