#include "identify/breakaway_trend.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

constexpr size_t highestTrend = 30;
constexpr size_t highestFine = 110, mostFine = 4;
constexpr size_t leastForFine = 240;  // breakaways: 30 orders' worth
constexpr double surelyFine = 40.0;   // gain in χ² of a finer order; the best of eighty gains ten by chance
constexpr size_t highestFinest = 200, leastForFinest = 80;  // that are looked for, but not followed
constexpr double likelyFine = 20.0;                         // likewise, of these
constexpr double leastSpread = 0.08;  // of cosines' and sines' determinant, over breakaways squared; even: 0.25
constexpr int learningRounds = 40;
constexpr double leastScatter2 = 1e-10;  // square of the least scatter, part of the breakaways' own variance
constexpr double leastWave2 = 1e-8;      // of an order's variance, likewise

}  // namespace

BreakawayTrend::BreakawayTrend(const std::vector<BreakawayEvent>& events, Way way) {
  std::copy_if(events.begin(), events.end(), std::back_inserter(events_),
               [way](const BreakawayEvent& event) { return event.way == way; });
  for (size_t k = 1; k <= std::min(highestTrend, events_.size() / 8); ++k) orders_.push_back(static_cast<double>(k));
  fit();
  for (size_t k = 0; k < mostFine && events_.size() >= leastForFine; ++k) {
    const FineWave finer = finest(highestTrend + 1, highestFine, surelyFine);
    if (finer.order == 0) return;
    orders_.push_back(static_cast<double>(finer.order));
    fit();
  }
}

double BreakawayTrend::finerThan_Nm2(size_t order) const {
  if (events_.size() < leastForFinest) return 0.0;
  double sum = 0.0;
  for (const BreakawayEvent& event : events_) {
    const Eigen::VectorXd row = rowAt(event.angle_rad);
    double finer_Nm = 0.0;
    for (size_t k = 0; k < orders_.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(2 * k + 1);
      if (orders_[k] > static_cast<double>(order)) finer_Nm += row.segment<2>(at).dot(x_.segment<2>(at));
    }
    sum += finer_Nm * finer_Nm;
  }
  return sum / static_cast<double>(events_.size()) +
         finest(std::max(order, highestTrend) + 1, highestFinest, likelyFine).square_Nm2;
}

/// The one among these orders, beyond those that are followed, that takes most off what they leave; none where chance
/// could have made it. `gain`: in χ², that it takes at least.
BreakawayTrend::FineWave BreakawayTrend::finest(size_t first, size_t last, double gain) const {
  std::vector<double> left;
  double squares = 0.0;
  for (const BreakawayEvent& event : events_) {
    left.push_back(event.torque_Nm - torqueAt_Nm(event.angle_rad));
    squares += left.back() * left.back();
  }
  const auto count = static_cast<double>(events_.size());
  FineWave best{0, gain * squares / count / count};
  for (size_t k = first; k <= last; ++k) {
    if (std::find(orders_.begin(), orders_.end(), static_cast<double>(k)) != orders_.end()) continue;
    double c = 0.0, s = 0.0, cc = 0.0, ss = 0.0, cs = 0.0, meanX = 0.0, meanY = 0.0;
    for (size_t j = 0; j < left.size(); ++j) {
      const double angle = static_cast<double>(k) * events_[j].angle_rad, x = std::cos(angle), y = std::sin(angle);
      c += left[j] * x, s += left[j] * y, cc += x * x, ss += y * y, cs += x * y, meanX += x / count, meanY += y / count;
    }
    // Around their means: where strong cogging lets a rotor rest in its valleys only, its crests are nobody's guess.
    cc -= count * meanX * meanX, ss -= count * meanY * meanY, cs -= count * meanX * meanY;
    const double determinant = cc * ss - cs * cs;
    if (!(determinant > leastSpread * count * count)) continue;
    const double taken = (ss * c * c - 2.0 * cs * c * s + cc * s * s) / determinant;
    if (taken / count > best.square_Nm2) best = {k, taken / count};
  }
  return best.order > 0 ? best : FineWave{};
}

void BreakawayTrend::fit() {
  const auto orders = static_cast<Eigen::Index>(orders_.size());
  const Eigen::Index n = 2 * orders + 1;
  const auto count = static_cast<double>(events_.size());
  x_ = Eigen::VectorXd::Zero(n);
  covariance_ = Eigen::MatrixXd::Zero(n, n);
  if (events_.empty()) return;
  double mean = 0.0, squares = 0.0;
  for (const BreakawayEvent& event : events_) mean += event.torque_Nm / count;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (const BreakawayEvent& event : events_) {
    const Eigen::VectorXd row = rowAt(event.angle_rad);
    const double over = event.torque_Nm - mean;
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
    covariance_ = inverseOfSymmetric(precision);
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
