#include "identify/breakaway_trend.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr size_t highestTrend = 30;
constexpr int learningRounds = 40;
constexpr double leastScatter2 = 1e-10;  // square of the least scatter, part of the breakaways' own variance
constexpr double leastWave2 = 1e-8;      // of an order's variance, likewise

}  // namespace

BreakawayTrend::BreakawayTrend(const std::vector<BreakawayEvent>& events, Way way) {
  std::vector<const BreakawayEvent*> same;
  for (const BreakawayEvent& event : events) {
    if (event.way == way) same.push_back(&event);
  }
  const auto orders = static_cast<Eigen::Index>(std::min(highestTrend, same.size() / 8));
  const Eigen::Index n = 2 * orders + 1;
  const auto count = static_cast<double>(same.size());
  x_ = Eigen::VectorXd::Zero(n);
  covariance_ = Eigen::MatrixXd::Zero(n, n);
  if (same.empty()) return;
  double mean = 0.0, squares = 0.0;
  for (const BreakawayEvent* event : same) mean += event->torque_Nm / count;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (const BreakawayEvent* event : same) {
    const Eigen::VectorXd row = rowAt(event->angle_rad);
    const double over = event->torque_Nm - mean;
    normal += row * row.transpose();
    right += over * row;
    squares += over * over;
  }
  const double whole = squares / count;
  if (!(whole > 0.0)) {
    x_[0] = mean;
    return;
  }
  double scatter = 0.1 * whole;
  Eigen::VectorXd waves =
      Eigen::VectorXd::Constant(orders, whole / static_cast<double>(std::max<Eigen::Index>(1, orders)));
  for (int round = 0; round < learningRounds; ++round) {
    Eigen::MatrixXd precision = normal / scatter;
    precision(0, 0) += 1e-3 / whole;
    for (Eigen::Index k = 0; k < orders; ++k) {
      precision(2 * k + 1, 2 * k + 1) += 1.0 / waves[k];
      precision(2 * k + 2, 2 * k + 2) += 1.0 / waves[k];
    }
    covariance_ = precision.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
    x_ = covariance_ * right / scatter;
    for (Eigen::Index k = 0; k < orders; ++k) {
      const double power = x_.segment<2>(2 * k + 1).squaredNorm() + covariance_(2 * k + 1, 2 * k + 1) +
                           covariance_(2 * k + 2, 2 * k + 2);
      waves[k] = std::max(0.5 * power, leastWave2 * whole);
    }
    const double left = squares - 2.0 * x_.dot(right) + x_.dot(normal * x_) + normal.cwiseProduct(covariance_).sum();
    scatter = std::max(left / count, leastScatter2 * whole);
  }
  x_[0] += mean;
}

double BreakawayTrend::slopeAt_Nm_per_rad(double angle_rad) const {
  const Eigen::VectorXd row = rowAt(angle_rad);
  double slope = 0.0;
  for (Eigen::Index k = 1; 2 * k < x_.size(); ++k)
    slope += static_cast<double>(k) * (row[2 * k - 1] * x_[2 * k] - row[2 * k] * x_[2 * k - 1]);
  return slope;
}

double BreakawayTrend::errorAt_Nm(double angle_rad) const {
  const Eigen::VectorXd row = rowAt(angle_rad);
  return std::sqrt(std::max(0.0, row.dot(covariance_ * row)));
}

Eigen::VectorXd BreakawayTrend::rowAt(double angle_rad) const {
  Eigen::VectorXd row(x_.size());
  row[0] = 1.0;
  for (Eigen::Index k = 1; 2 * k < row.size(); ++k) {
    row[2 * k - 1] = std::cos(static_cast<double>(k) * angle_rad);
    row[2 * k] = std::sin(static_cast<double>(k) * angle_rad);
  }
  return row;
}

}  // namespace breakaway
