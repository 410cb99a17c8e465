#include "identify/friction_line.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double fallDoubt = 0.3;       // of friction's fall with speed: its shape is not known
constexpr double surelyFalling = 12.0;  // gain in χ² by which the fall must show
constexpr double leftOutErrors = 3.0;   // standard errors off the line through the faster runs

/// C + B·|ω| for one order.
FrictionLine fitLine(const WayRuns& runs, size_t order, bool withSlope, Complex guess) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero(), squared = normal;
  Eigen::Matrix<Complex, 2, 1> right = Eigen::Matrix<Complex, 2, 1>::Zero();
  const auto rows = lineRows(runs, order, guess);
  FrictionLine line;
  for (const LineRow& row : rows) {
    const Eigen::Matrix2d square = row.regressors * row.regressors.transpose();
    normal += row.weight * square;
    squared += row.weight * row.weight * square;
    line.squaresPerExtra += 2.0 * row.weight;
    right += (row.weight * row.torque_Nm) * row.regressors.cast<Complex>();
  }
  if (normal(0, 0) == 0.0) return line;
  const bool slope = withSlope && normal.determinant() > 1e-12 * normal(0, 0) * normal(1, 1);
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  covariance(0, 0) = 1.0 / normal(0, 0);
  line.lean = normal(0, 1) / normal(0, 0);
  if (slope) covariance = normal.inverse();
  line.coulomb = covariance(0, 0) * right[0] + covariance(0, 1) * right[1];
  line.viscous = covariance(1, 0) * right[0] + covariance(1, 1) * right[1];
  line.coulombVariance = covariance(0, 0);
  line.viscousVariance = slope ? covariance(1, 1) : std::numeric_limits<double>::infinity();
  line.covariance = covariance(0, 1);
  line.squaresPerExtra -= 2.0 * (covariance * squared).trace();
  for (const LineRow& row : rows)
    line.squares +=
        row.weight * std::norm(row.torque_Nm - line.coulomb * row.regressors[0] - line.viscous * row.regressors[1]);
  return line;
}

}  // namespace

std::vector<LineRow> lineRows(const WayRuns& runs, size_t order, Complex guess) {
  const Complex still = order < runs.static_Nm.size() ? runs.static_Nm[order] : Complex(0.0);
  std::vector<LineRow> rows;
  for (size_t j = 0; j < runs.spectra.size(); ++j) {
    const RunSpectrum& one = runs.spectra[j];
    if (order >= one.torque_Nm.size() || std::isinf(one.variance_Nm2[order])) continue;
    const double g = runs.fall[j], doubt = fallDoubt * g * std::abs(still - guess);
    const double variance = one.variance_Nm2[order] + (order == 0 ? runs.widened_Nm2[j] : 0.0) + doubt * doubt;
    rows.push_back({Eigen::Vector2d(1.0 - g, one.speed_rad_per_s), one.torque_Nm[order] - g * still,
                    one.speed_rad_per_s, 1.0 / variance});
  }
  return rows;
}

HarmonicEvidence FrictionLine::coulombGiven(const WeighedHarmonic& known) const {
  if (std::isinf(viscousVariance))
    return {coulomb - lean * known.value, coulombVariance + lean * lean * known.variance};
  const double slope = covariance / viscousVariance;
  return {coulomb + slope * (known.value - viscous),
          std::max(0.0, coulombVariance - slope * covariance) + slope * slope * known.variance};
}

/// With the fall's doubt measured by the fit's own Coulomb value.
FrictionLine fitOrder(const WayRuns& runs, size_t order, bool withSlope) {
  const FrictionLine first = fitLine(runs, order, withSlope, 0.0);
  return fitLine(runs, order, withSlope, first.coulomb);
}

void setFall(WayRuns& runs, double speed_rad_per_s) {
  for (size_t j = 0; j < runs.spectra.size(); ++j) {
    const double x = runs.spectra[j].speed_rad_per_s / speed_rad_per_s;
    runs.fall[j] = speed_rad_per_s > 0.0 ? std::exp(-x * x) : 0.0;
  }
}

double findFall(std::array<WayRuns, 2> ways) {
  const auto squaresAt = [&ways](double speed) {
    double squares = 0.0;
    for (WayRuns& runs : ways) {
      setFall(runs, speed);
      squares += fitLine(runs, 0, true, runs.static_Nm.empty() ? 0.0 : runs.static_Nm[0]).squares;
    }
    return squares;
  };
  const double slowest = ways[0].spectra.front().speed_rad_per_s, fastest = ways[0].spectra.back().speed_rad_per_s;
  const double without = squaresAt(0.0);
  double best = 0.0, bestSquares = without - surelyFalling;
  for (double speed = 0.35 * slowest; speed < 0.4 * fastest; speed *= 1.02) {
    const double squares = squaresAt(speed);
    if (squares < bestSquares) bestSquares = squares, best = speed;
  }
  return best;
}

void widen(WayRuns& runs) {
  const auto spare = static_cast<double>(runs.spectra.size()) - 2.0;
  if (spare <= 0.0) return;
  double low = 0.0, high = 0.0;
  const auto squaresWith = [&runs](double extra) {
    runs.widened_Nm2.assign(runs.spectra.size(), extra);
    return fitOrder(runs, 0, true).squares;
  };
  if (squaresWith(0.0) <= spare) return;
  high = std::norm(0.1 * runs.spectra.back().torque_Nm[0]);
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (squaresWith(middle) > spare ? low : high) = middle;
  }
  squaresWith(high);
}

namespace {

constexpr size_t reach = 2;       // orders on either side that residuals are pooled over
constexpr double byChance = 2.0;  // deviations of χ² that residuals may exceed their mean by
constexpr size_t leastRuns = 4;   // that an order must show in

size_t runsShowing(const WayRuns& runs, size_t order) {
  size_t count = 0;
  for (const RunSpectrum& one : runs.spectra)
    count += order < one.variance_Nm2.size() && !std::isinf(one.variance_Nm2[order]) ? 1 : 0;
  return count;
}

/// The variance that explains what the residuals of these orders are beyond their own, by their mean: where slow runs
/// are exact and fast ones aren't, what is odd about a fast one says little of the slow ones (DerSimonian and Laird,
/// "Meta-analysis in clinical trials", 1986, equation 8, for a line). 0 where chance may be all.
double excess_Nm2(const WayRuns& runs, size_t first, size_t last, size_t highestSlope) {
  double squares = 0.0, spare = 0.0, perExtra = 0.0;
  for (size_t k = first; k <= last; ++k) {
    const size_t shown = runsShowing(runs, k);
    if (shown < leastRuns) continue;
    const FrictionLine line = fitOrder(runs, k, k <= highestSlope);
    spare += 2.0 * static_cast<double>(shown - (std::isinf(line.viscousVariance) ? 1 : 2));
    squares += line.squares;
    perExtra += line.squaresPerExtra;
  }
  if (!(perExtra > 0.0) || squares <= spare + byChance * std::sqrt(2.0 * spare)) return 0.0;
  return (squares - spare) / perExtra;
}

}  // namespace

void widenHarmonics(WayRuns& runs, size_t highestSlope) {
  size_t highest = 0;
  for (const RunSpectrum& one : runs.spectra) highest = std::max(highest, one.variance_Nm2.size() - 1);
  std::vector<double> extra(highest + 1, 0.0);
  for (size_t k = 1; k <= highest; ++k) {
    const size_t first = k > reach ? k - reach : 1, last = std::min(k + reach, highest);
    extra[k] = std::max(excess_Nm2(runs, k, k, highestSlope), excess_Nm2(runs, first, last, highestSlope));
  }
  for (RunSpectrum& one : runs.spectra) {
    for (size_t k = 1; k < one.variance_Nm2.size(); ++k) one.variance_Nm2[k] += extra[k];
  }
}

size_t leaveOutStribeck(WayRuns& runs) {
  size_t leftOut = 0;
  while (runs.spectra.size() > 3) {
    WayRuns faster = runs;
    faster.spectra.erase(faster.spectra.begin());
    faster.fall.erase(faster.fall.begin());
    faster.widened_Nm2.erase(faster.widened_Nm2.begin());
    WayRuns widened = faster;
    widen(widened);
    const FrictionLine line = fitOrder(widened, 0, true);
    const RunSpectrum& slow = runs.spectra.front();
    const double w = slow.speed_rad_per_s;
    const double off = std::abs(slow.torque_Nm[0] - line.coulomb - line.viscous * w);
    const double error = std::sqrt(slow.variance_Nm2[0] + line.coulombVariance + w * w * line.viscousVariance +
                                   2.0 * w * line.covariance);
    if (off < leftOutErrors * error || off < 0.003 * std::abs(line.coulomb)) break;
    runs = faster;
    ++leftOut;
  }
  return leftOut;
}

}  // namespace breakaway
