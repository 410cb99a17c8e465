#include "motor/winding_line.h"

#include <fmt/core.h>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

struct LineFit {
  Eigen::Vector2d x = Eigen::Vector2d::Zero();  // conductance in 1/ohm, offset in A
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  double squares = 0.0;
};

double beyond(double voltage_V, double deadZone_V) {
  return std::copysign(std::max(0.0, std::abs(voltage_V) - deadZone_V), voltage_V);
}

LineFit fitWith(const std::vector<WindingPoint>& points, double deadZone_V) {
  LineFit fit;
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const WindingPoint& point : points) {
    const Eigen::Vector2d row(beyond(point.voltage_V, deadZone_V), 1.0);
    fit.normal += row * row.transpose();
    right += row * point.current_A;
  }
  fit.x = leastNorm(fit.normal, right);
  for (const WindingPoint& point : points) {
    const double e = point.current_A - fit.x[0] * beyond(point.voltage_V, deadZone_V) - fit.x[1];
    fit.squares += e * e;
  }
  return fit;
}

/// The minimum of the squares over the dead zone, refined around the best of a grid.
double searchDeadZone(const std::vector<WindingPoint>& points, double highest_V) {
  double low = 0.0, high = 0.98 * highest_V, best = 0.0;
  for (int round = 0; round < 6; ++round) {
    const int cells = 24;
    double bestSquares = -1.0;
    for (int k = 0; k <= cells; ++k) {
      const double candidate = low + (high - low) * k / cells;
      const double squares = fitWith(points, candidate).squares;
      if (bestSquares < 0.0 || squares < bestSquares) bestSquares = squares, best = candidate;
    }
    const double width = (high - low) / cells;
    low = std::max(0.0, best - width);
    high = best + width;
  }
  return best;
}

}  // namespace

double WindingLine::voltageFor(double current_A) const {
  if (current_A == 0.0) return 0.0;
  return current_A * resistance_ohm.value + std::copysign(deadZone_V.value, current_A);
}

Result<WindingLine> fitWindingLine(const std::vector<WindingPoint>& points) {
  if (points.size() < 20)
    return Error{"winding", "has " + std::to_string(points.size()) + " standing points, expected at least 20"};
  double highest = 0.0;
  for (const WindingPoint& point : points) highest = std::max(highest, std::abs(point.voltage_V));
  const double deadZone = searchDeadZone(points, highest);
  const LineFit fit = fitWith(points, deadZone);
  const double variance = fit.squares / static_cast<double>(points.size() - 3);
  // The dead zone shifts the current by −sgn(v)/R beyond it; its error and the slope's are correlated, so solve for all
  // three.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  for (const WindingPoint& point : points) {
    const double u = beyond(point.voltage_V, deadZone);
    const Eigen::Vector3d row(u, u == 0.0 ? 0.0 : -std::copysign(fit.x[0], u), 1.0);
    normal += row * row.transpose();
  }
  const Eigen::Matrix3d covariance = variance * pseudoInverse(normal);
  const double slope = fit.x[0], slopeError = std::sqrt(std::max(0.0, covariance(0, 0)));
  const bool constant = std::all_of(points.begin(), points.end(), [&points](const WindingPoint& one) {
    return one.current_A == points.front().current_A;
  });
  if (constant)
    return Error{"winding", fmt::format("reads exactly {:g} A up to {:.2g} V: the current sensor is dead; check its "
                                        "supply and its wire",
                                        points.front().current_A, highest)};
  if (slope < -5.0 * slopeError)
    return Error{"winding",
                 "shows a current that falls as the voltage rises: the current sensor is reversed; swap its "
                 "leads, or the sign in the board"};
  if (!(slope > 5.0 * slopeError)) return Error{"winding", "shows no current that stands out of the sensor's noise"};
  WindingLine line;
  line.resistance_ohm = {1.0 / slope, slopeError / (slope * slope)};
  line.deadZone_V = {deadZone, std::sqrt(std::max(0.0, covariance(1, 1)))};
  line.offset_A = {fit.x[1], std::sqrt(std::max(0.0, covariance(2, 2)))};
  return line;
}

}  // namespace breakaway
