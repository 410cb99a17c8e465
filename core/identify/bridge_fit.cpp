#include "identify/bridge_fit.h"

#include <fmt/core.h>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

constexpr size_t leastBridgeRows = 200;
constexpr double lastKnot_duty = 0.22;
constexpr double knots_duty[] = {0.004, 0.009, 0.018, 0.035, 0.07, 0.14, lastKnot_duty};  // beyond the dead zone
constexpr double reach_duty = 0.08;       // of voltages beyond the last knot
constexpr double steepest_duty = 0.05;    // change of the voltage over two blocks, above which means say little
constexpr double mostError = 0.02;        // relative standard error of the resistance
constexpr double leastBend = 0.1;         // of the slope, for a curve
constexpr double leastLost_duty = 0.002;  // by it, likewise; a timer's steps round the dead zone's end by less
constexpr double significance = 5.0;      // standard errors of that bend
constexpr double flat = 0.1;              // of the far slope: no current yet
constexpr double keep = 3.0;              // standard errors below which a knot goes
constexpr double bentDoubt = 9e-4;        // relative, of a bent bridge: what bends on beyond the last knot
constexpr double curveDoubt = 2e-4;       // relative: blocks, ticks and the winding's lag
constexpr size_t mostTogether = 16;       // blocks of a row
constexpr double littleRounding = 0.002;  // of the slopes, that isn't worth longer rows
constexpr double usualSag = 0.05;       // of the winding's resistance: a supply's with its leads, before it is measured
constexpr double sagDoubt = 0.02;       // of the winding's resistance, seen on benches of other makes
constexpr double stretch_s = 0.3;       // over which rows may err alike
constexpr double roundingDoubt = 0.15;  // of what the encoder's rounding changes: it is no noise at a steady speed

/// Some blocks in a row, mostly one: current with its lag, the voltages, speed.
struct BridgeRow {
  double current_A = 0.0, speed_rad_per_s = 0.0, weight = 1.0;
  std::vector<double> voltages_V;
  Eigen::Index test = 0;
  double rounding = 0.0;  ///< variance of the speed by the encoder's counts
  double sag_A = 0.0;     ///< current times the square of the duty: what a supply's resistance takes away is like it
  double sagPerSpeed_A_s = 0.0;  ///< that a speed's error adds to it
};

/// Blocks from `k` on of a test, as many as `together`; fewer where the voltage changes steeply.
BridgeRow rowOf(const BridgeTests& tests, size_t test, size_t k, size_t together) {
  const auto& blocks = tests.moving[test];
  BridgeRow row{.weight = 0.0, .voltages_V = {}, .test = static_cast<Eigen::Index>(test) + 1};
  const double from_rad = blocks[k - 1].angle_rad;
  double charge_As = 0.0;
  for (const size_t end = std::min(k + together, blocks.size() - 1); k < end; ++k) {
    const SpinBlock &before = blocks[k - 1], &here = blocks[k], &after = blocks[k + 1];
    if (std::abs(after.voltage_V - before.voltage_V) > steepest_duty * tests.supply_V) break;
    const double across_s = here.duration_s + 0.5 * (before.duration_s + after.duration_s);
    const double lag_A = tests.timeConstant_s * (after.current_A - before.current_A) / across_s;
    charge_As += here.duration_s * (here.current_A + lag_A);
    row.weight += here.duration_s;
    row.voltages_V.push_back(here.voltage_V);
  }
  if (row.voltages_V.empty()) return row;
  row.current_A = charge_As / row.weight;
  row.speed_rad_per_s = (blocks[k - 1].angle_rad - from_rad) / row.weight;
  row.rounding = tests.count_rad * tests.count_rad / 6.0 / (row.weight * row.weight);
  return row;
}

std::vector<BridgeRow> rowsOf(const BridgeTests& tests, size_t together) {
  std::vector<BridgeRow> rows;
  rows.reserve(tests.standing.size());
  for (const WindingPoint& point : tests.standing)
    rows.push_back({point.current_A, 0.0, tests.standingBlock_s, {point.voltage_V}});
  for (size_t t = 0; t < tests.moving.size(); ++t) {
    for (size_t k = 1; k + 1 < tests.moving[t].size();) {
      BridgeRow row = rowOf(tests, t, k, together);
      k += std::max<size_t>(1, row.voltages_V.size());
      if (!row.voltages_V.empty()) rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// Slopes (the first, and by how much each knot changes it), Ke/R, the tests' zeros, and the supply's resistance over
/// R.
struct Fit {
  Eigen::VectorXd x;
  Eigen::MatrixXd covariance;
  double squares = 0.0, residual = 0.0;
  double rounding = 0.0;  ///< relative, by which the encoder's would have made R larger
};

class BridgeLine {
 public:
  BridgeLine(std::vector<BridgeRow> rows, Eigen::Index tests) : rows_(std::move(rows)), tests_(tests) {}

  /// From now on the supply falls by its own resistance times what the bridge takes from it, as far as the currents of
  /// the fit so far tell: measured ones would bring their noise.
  void letSupplyFall(const Fit& fit, const std::vector<double>& knots_V, double supply_V) {
    for (BridgeRow& row : rows_) {
      double square = 0.0, mean_V = 0.0;
      for (const double voltage_V : row.voltages_V) square += voltage_V * voltage_V, mean_V += voltage_V;
      const double current_A = regressor(row, knots_V).dot(fit.x) - fit.x[zeroOf(row, knots_V.size())];
      const auto blocks = static_cast<double>(row.voltages_V.size());
      const double share = mean_V * current_A > 0.0 ? square / blocks / (supply_V * supply_V) : 0.0;
      row.sag_A = share * current_A;
      row.sagPerSpeed_A_s = -share * fit.x[static_cast<Eigen::Index>(knots_V.size())];
    }
    prior_ = spread(fit) * alike(fit, knots_V) / (usualSag * usualSag);
  }

  /// `knots_V`: where the slope changes, the dead zone's end first.
  Fit fit(const std::vector<double>& knots_V) const {
    const auto slopes = static_cast<Eigen::Index>(knots_V.size()), n = slopes + 2 + tests_;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    double squares = 0.0;
    Eigen::Matrix2d roundings = Eigen::Matrix2d::Zero();  // of the speed's and the supply's column
    for (const BridgeRow& row : rows_) {
      const Eigen::Vector2d perSpeed(1.0, row.sagPerSpeed_A_s);
      roundings += row.weight * row.rounding * perSpeed * perSpeed.transpose();
      const Eigen::VectorXd a = regressor(row, knots_V);
      normal.selfadjointView<Eigen::Lower>().rankUpdate(a, row.weight);
      right += row.weight * row.current_A * a;
      squares += row.weight * row.current_A * row.current_A;
    }
    normal = normal.selfadjointView<Eigen::Lower>();
    normal(n - 1, n - 1) += prior_;
    const Eigen::MatrixXd seen = normal;
    const double rounding = roundings(0, 0);
    const std::array both{slopes, n - 1};
    normal(both, both) -= roundings;
    const Eigen::MatrixXd inverse = pseudoInverse(normal);
    Fit fit;
    fit.x = inverse * right;
    fit.squares = squares - fit.x.dot(right);
    const double residual = squares - 2.0 * fit.x.dot(right) + fit.x.dot(seen * fit.x);
    if (rounding > 0.0) fit.rounding = roundingShare(fit.x, seen, right, slopes);
    fit.residual = std::max(0.0, residual);
    fit.covariance = spread(fit) * (rounding > 0.0 ? Eigen::MatrixXd(inverse * seen * inverse) : inverse);
    return fit;
  }

  /// Moves the first `together` knots to where the squares are least, the first of them within low_V to high_V.
  void search(std::vector<double>& knots_V, size_t together, double low_V, double high_V) const {
    const std::vector<double> from = knots_V;
    double low = low_V, high = high_V, best = low_V;
    const auto squaresAt = [&](double first_V) {
      for (size_t k = 0; k < together; ++k) knots_V[k] = from[k] + first_V - from[0];
      return fit(knots_V).squares;
    };
    for (int round = 0; round < 5; ++round) {
      constexpr int cells = 16;
      double least = -1.0;
      for (int k = 0; k <= cells; ++k) {
        const double candidate = low + (high - low) * k / cells, squares = squaresAt(candidate);
        if (least < 0.0 || squares < least) least = squares, best = candidate;
      }
      const double width = (high - low) / cells;
      low = std::max(low_V, best - width);
      high = std::min(high_V, best + width);
    }
    squaresAt(best);
  }

  /// The first knot's standard error, from how fast the squares grow around it.
  double errorOfFirst(const std::vector<double>& knots_V, double step_V) const {
    const auto squaresAt = [&](double by_V) {
      std::vector<double> moved = knots_V;
      moved.front() += by_V;
      return fit(moved).squares;
    };
    const double here = squaresAt(0.0),
                 bend = (squaresAt(step_V) + squaresAt(-step_V) - 2.0 * here) / (step_V * step_V);
    const double variance = std::max(0.0, here) / static_cast<double>(rows_.size());
    return bend > 0.0 ? std::sqrt(2.0 * variance / bend) : step_V;
  }

 private:
  /// By the far slope without what is taken off the speed's square.
  static double roundingShare(const Eigen::VectorXd& x, const Eigen::MatrixXd& seen, const Eigen::VectorXd& right,
                              Eigen::Index slopes) {
    const Eigen::VectorXd plain = leastNorm(seen, right);
    return std::abs(x.head(slopes).sum() / plain.head(slopes).sum() - 1.0);
  }
  /// Variance of a row of weight 1.
  double spread(const Fit& fit) const {
    return fit.residual / static_cast<double>(rows_.size() - static_cast<size_t>(fit.x.size()));
  }
  /// How much more than single rows those of a stretch tell in their sum, at least 1: what they have in common, such as
  /// cogging or a curve's remainder, mustn't pass for many rows' word.
  double alike(const Fit& fit, const std::vector<double>& knots_V) const {
    double together = 0.0, alone = 0.0, sum = 0.0, span_s = 0.0;
    Eigen::Index test = -1;
    for (const BridgeRow& row : rows_) {
      if (row.test != test || span_s >= stretch_s) {
        together += sum * sum;
        sum = span_s = 0.0;
        test = row.test;
      }
      const double left = std::sqrt(row.weight) * (row.current_A - regressor(row, knots_V).dot(fit.x));
      sum += left;
      alone += left * left;
      span_s += row.weight;
    }
    together += sum * sum;
    return alone > 0.0 ? std::max(1.0, together / alone) : 1.0;
  }
  static Eigen::Index zeroOf(const BridgeRow& row, size_t knots) {
    return static_cast<Eigen::Index>(knots) + 1 + row.test;
  }
  Eigen::VectorXd regressor(const BridgeRow& row, const std::vector<double>& knots_V) const {
    const auto slopes = static_cast<Eigen::Index>(knots_V.size());
    Eigen::VectorXd a = Eigen::VectorXd::Zero(slopes + 2 + tests_);
    const double share = 1.0 / static_cast<double>(row.voltages_V.size());
    for (const double voltage_V : row.voltages_V) {
      for (Eigen::Index k = 0; k < slopes; ++k)
        a[k] += share * std::copysign(std::max(0.0, std::abs(voltage_V) - knots_V[static_cast<size_t>(k)]), voltage_V);
    }
    a[slopes] = -row.speed_rad_per_s;
    a[zeroOf(row, knots_V.size())] = 1.0;
    a[slopes + 1 + tests_] = -row.sag_A;
    return a;
  }

  std::vector<BridgeRow> rows_;
  Eigen::Index tests_;
  double prior_ = 1.0;  ///< of the last unknown's square; nothing else holds it while no row has its part
};

/// Takes away, one by one, the knots that change the slope by less than their doubt.
Fit pruned(const BridgeLine& line, std::vector<double>& knots_V) {
  while (true) {
    Fit fit = line.fit(knots_V);
    size_t weakest = 0;
    double least = keep;
    for (size_t k = 1; k < knots_V.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      const double standing = std::abs(fit.x[at]) / std::sqrt(std::max(1e-300, fit.covariance(at, at)));
      if (standing < least) least = standing, weakest = k;
    }
    if (weakest == 0) return fit;
    knots_V.erase(knots_V.begin() + static_cast<std::ptrdiff_t>(weakest));
  }
}

double farSlope(const Fit& fit, size_t slopes) {
  return fit.x.head(static_cast<Eigen::Index>(slopes)).sum();
}

/// The first stretch between two knots on which the current hardly grows; none: the knots' number.
size_t flatStretch(const Fit& fit, const std::vector<double>& knots_V) {
  const double far = farSlope(fit, knots_V.size());
  double slope = 0.0;
  for (size_t k = 0; k + 1 < knots_V.size(); ++k) {
    slope += fit.x[static_cast<Eigen::Index>(k)];
    if (slope < flat * far) return k;
  }
  return knots_V.size();
}

/// The knots from the dead zone's end on, where the current begins.
Fit fitted(const BridgeLine& line, std::vector<double>& knots_V, double most_V) {
  line.search(knots_V, knots_V.size(), 0.0, most_V);
  Fit fit = pruned(line, knots_V);
  for (size_t k = flatStretch(fit, knots_V); k < knots_V.size(); k = flatStretch(fit, knots_V)) {
    // Nothing flows up to the second knot, or the noise makes a later stretch flat: one knot less.
    knots_V.erase(knots_V.begin() + static_cast<std::ptrdiff_t>(k == 0 ? 0 : k + 1));
    fit = pruned(line, knots_V);
  }
  const double room_V = knots_V.size() > 1 ? 0.9 * (knots_V[1] - knots_V[0]) : 0.5 * most_V;
  line.search(knots_V, 1, std::max(0.0, knots_V[0] - 0.5 * most_V), knots_V[0] + room_V);
  return pruned(line, knots_V);
}

/// A quantity of the fit with the error that follows from its gradient.
Estimate estimateOf(double value, const Eigen::VectorXd& gradient, const Fit& fit) {
  return {value, std::sqrt(std::max(0.0, gradient.dot(fit.covariance * gradient)))};
}

DutyCurve curveOf(const Fit& fit, const std::vector<double>& knots_V, double supply_V) {
  DutyCurve curve;
  const double far = farSlope(fit, knots_V.size());
  for (const double at_V : knots_V) {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.x.size());
    double sum = 0.0;
    for (size_t k = 0; k < knots_V.size() && knots_V[k] < at_V; ++k) {
      sum += fit.x[static_cast<Eigen::Index>(k)] * (at_V - knots_V[k]);
      gradient[static_cast<Eigen::Index>(k)] = (at_V - knots_V[k]) / far / supply_V;
    }
    const double output = sum / far / supply_V;
    for (size_t k = 0; k < knots_V.size(); ++k) gradient[static_cast<Eigen::Index>(k)] -= output / far;
    curve.points.push_back({at_V / supply_V, estimateOf(output, gradient, fit)});
  }
  curve.points.front().output = {};
  return curve;
}

/// Most of what the curve gives more or less than the duty beyond its dead zone, part of the supply.
double mostLost(const DutyCurve& curve) {
  double most = 0.0;
  for (const DutyPoint& point : curve.points)
    most = std::max(most, std::abs(point.input - curve.points.front().input - point.output.value));
  return most;
}

/// Whether the slope between some knots stands out of the far slope.
bool bends(const Fit& fit, const std::vector<double>& knots_V) {
  const auto slopes = static_cast<Eigen::Index>(knots_V.size());
  const double far = farSlope(fit, knots_V.size());
  for (Eigen::Index k = 0; k + 1 < slopes; ++k) {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.x.size());
    gradient.segment(k + 1, slopes - k - 1).setOnes();
    const Estimate bend = estimateOf(fit.x.segment(k + 1, slopes - k - 1).sum(), gradient, fit);
    if (std::abs(bend.value) > std::max(leastBend * far, significance * bend.standardError)) return true;
  }
  return false;
}

/// As many blocks together as bring the encoder's rounding down, but no more than tell speeding up from slowing down.
BridgeLine lineOf(const BridgeTests& tests) {
  const auto parts = static_cast<Eigen::Index>(tests.moving.size()) + 1;
  for (size_t together = 1;; together *= 2) {
    BridgeLine line(rowsOf(tests, together), parts);
    if (2 * together > mostTogether || line.fit({0.0}).rounding < littleRounding) return line;
  }
}

double highestStanding(const BridgeTests& tests) {
  double highest_V = 0.0;
  for (const WindingPoint& point : tests.standing) highest_V = std::max(highest_V, std::abs(point.voltage_V));
  return highest_V;
}

/// Other things bend like a supply that falls, such as a winding that warms up: what that does to all else is its
/// doubt.
void doubtSag(Fit& fit) {
  const Eigen::Index sag = fit.x.size() - 1;
  const double variance = fit.covariance(sag, sag);
  if (!(variance > 0.0)) return;
  const Eigen::VectorXd along = fit.covariance.col(sag) / variance;
  fit.covariance += sagDoubt * sagDoubt * along * along.transpose();
}

std::pair<Fit, std::vector<double>> fittedFrom(BridgeLine& line, const BridgeTests& tests, double standing_V) {
  std::vector<double> all_V{0.0};
  for (const double duty : knots_duty) all_V.push_back(duty * tests.supply_V);
  std::vector<double> knots_V = all_V;
  const Fit stiff = fitted(line, knots_V, 0.98 * standing_V);
  line.letSupplyFall(stiff, knots_V, tests.supply_V);
  knots_V = std::move(all_V);
  Fit fit = fitted(line, knots_V, 0.98 * standing_V);
  doubtSag(fit);
  return {std::move(fit), std::move(knots_V)};
}

/// Ke is the speed's slope over that of the voltage far out.
Estimate backEmfOf(const Fit& fit, size_t knots) {
  const auto slopes = static_cast<Eigen::Index>(knots);
  const double far = farSlope(fit, knots), Ke = fit.x[slopes] / far;
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.x.size());
  gradient.head(slopes).setConstant(-Ke / far);
  gradient[slopes] = 1.0 / far;
  return estimateOf(Ke, gradient, fit);
}

}  // namespace

std::optional<Estimate> backEmfOfAnyCurve(const BridgeTests& tests) {
  if (rowsOf(tests, 1).size() < leastBridgeRows) return {};
  BridgeLine line = lineOf(tests);
  const auto [fit, knots_V] = fittedFrom(line, tests, highestStanding(tests));
  if (!(farSlope(fit, knots_V.size()) > 0.0)) return {};
  return backEmfOf(fit, knots_V.size());
}

Result<BridgeFit> fitBridge(const BridgeTests& tests) {
  const char* place = "bridge's curve";
  const std::vector<BridgeRow> rows = rowsOf(tests, 1);
  if (rows.size() < leastBridgeRows)
    return Error{place, message("has {} blocks only, expected at least 200", rows.size())};
  const double standing_V = highestStanding(tests);
  double highest_V = 0.0;
  for (const BridgeRow& row : rows) highest_V = std::max(highest_V, std::abs(row.voltages_V.front()));
  BridgeLine line = lineOf(tests);
  auto [fit, knots_V] = fittedFrom(line, tests, standing_V);
  const double reach_V = knots_V.front() + (lastKnot_duty + reach_duty) * tests.supply_V;
  if (highest_V < reach_V) {
    return Error{
        place,
        message(
            "can't be told: the tests reach {:.3g} V only, expected {:.3g} V, from where on it is taken as straight",
            highest_V, reach_V)};
  }
  const auto slopes = static_cast<Eigen::Index>(knots_V.size());
  const double far = farSlope(fit, knots_V.size());
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.x.size());
  gradient.head(slopes).setOnes();
  Estimate conductance = estimateOf(far, gradient, fit);
  conductance.standardError = std::hypot(conductance.standardError, roundingDoubt * fit.rounding * far);
  if (!(far > 0.0) || conductance.standardError > mostError * far)
    return Error{
        place, message("can't be told from the winding's resistance: the currents hardly differ at the same voltage")};
  BridgeFit found;
  DutyCurve curve = curveOf(fit, knots_V, tests.supply_V);
  const bool bent = bends(fit, knots_V) && mostLost(curve) >= leastLost_duty;
  const double doubt = bent ? bentDoubt : curveDoubt;
  found.resistance_ohm = {1.0 / far, std::hypot(conductance.standardError / far, doubt) / far};
  found.backEmfConstant_V_s_per_rad = backEmfOf(fit, knots_V.size());
  const double Ke = found.backEmfConstant_V_s_per_rad.value;
  found.backEmfConstant_V_s_per_rad.standardError =
      std::hypot(found.backEmfConstant_V_s_per_rad.standardError, doubt * Ke);
  found.deadZone_V = {knots_V.front(), line.errorOfFirst(knots_V, 5e-4 * tests.supply_V)};
  if (!bent) return found;
  found.curve = std::move(curve);
  if (!found.curve.rises()) return Error{place, message("doesn't rise with the duty everywhere, as the tests show it")};
  return found;
}

}  // namespace breakaway
