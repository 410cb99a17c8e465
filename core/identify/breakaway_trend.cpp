#include "identify/breakaway_trend.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr size_t highestTrend = 30;
constexpr size_t highestFine = 110, mostFine = 4;
constexpr size_t leastForFine = 240;  // breakaways: 30 orders' worth
constexpr double surelyFine = 40.0;   // gain in χ² of a finer order; the best of eighty gains ten by chance
constexpr double leastSpread = 0.08;  // of cosines' and sines' determinant, over breakaways squared; even: 0.25
constexpr int learningRounds = 40;
constexpr double leastScatter2 = 1e-10;  // square of the least scatter, part of the breakaways' own variance
constexpr double leastWave2 = 1e-8;      // of an order's variance, likewise

}  // namespace

BreakawayTrend::BreakawayTrend(const std::vector<BreakawayEvent>& events, Way way) {
  std::vector<const BreakawayEvent*> same;
  for (const BreakawayEvent& event : events) {
    if (event.way == way) same.push_back(&event);
  }
  for (size_t k = 1; k <= std::min(highestTrend, same.size() / 8); ++k) orders_.push_back(static_cast<double>(k));
  fit(same);
  for (size_t k = 0; k < mostFine && same.size() >= leastForFine; ++k) {
    const size_t order = finerOrder(same);
    if (order == 0) return;
    orders_.push_back(static_cast<double>(order));
    fit(same);
  }
}

/// The order beyond the others that takes most off what they leave; 0 where chance could have made it.
size_t BreakawayTrend::finerOrder(const std::vector<const BreakawayEvent*>& events) const {
  std::vector<double> left;
  double squares = 0.0;
  for (const BreakawayEvent* event : events) {
    left.push_back(event->torque_Nm - torqueAt_Nm(event->angle_rad));
    squares += left.back() * left.back();
  }
  const auto count = static_cast<double>(events.size());
  size_t best = 0;
  double most = surelyFine * squares / count;
  for (size_t k = highestTrend + 1; k <= highestFine; ++k) {
    if (std::find(orders_.begin(), orders_.end(), static_cast<double>(k)) != orders_.end()) continue;
    double c = 0.0, s = 0.0, cc = 0.0, ss = 0.0, cs = 0.0, meanX = 0.0, meanY = 0.0;
    for (size_t j = 0; j < left.size(); ++j) {
      const double angle = static_cast<double>(k) * events[j]->angle_rad, x = std::cos(angle), y = std::sin(angle);
      c += left[j] * x, s += left[j] * y, cc += x * x, ss += y * y, cs += x * y, meanX += x / count, meanY += y / count;
    }
    // Around their means: where strong cogging lets a rotor rest in its valleys only, its crests are nobody's guess.
    cc -= count * meanX * meanX, ss -= count * meanY * meanY, cs -= count * meanX * meanY;
    const double determinant = cc * ss - cs * cs;
    if (!(determinant > leastSpread * count * count)) continue;
    const double taken = (ss * c * c - 2.0 * cs * c * s + cc * s * s) / determinant;
    if (taken > most) most = taken, best = k;
  }
  return best;
}

void BreakawayTrend::fit(const std::vector<const BreakawayEvent*>& same) {
  const auto orders = static_cast<Eigen::Index>(orders_.size());
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
    slope += orders_[static_cast<size_t>(k - 1)] * (row[2 * k - 1] * x_[2 * k] - row[2 * k] * x_[2 * k - 1]);
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
    const double angle = orders_[static_cast<size_t>(k - 1)] * angle_rad;
    row[2 * k - 1] = std::cos(angle);
    row[2 * k] = std::sin(angle);
  }
  return row;
}

}  // namespace breakaway
