#include "diagnose/fit/drive_noise.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "dense/dense_solve.h"

namespace breakaway {

namespace {

constexpr size_t lags = 4;           ///< rows that a winding keeps the drive for
constexpr double steps = 4.0;        ///< times the noise: a change that was wanted
constexpr double leastNoise = 1e-4;  ///< of the drive's range: less moves nothing
constexpr Eigen::Index fewestRows = 200;
constexpr double clearly = 3.0;  ///< of the likelihood's logarithm, by which the one explanation beats the other

/// Values less the cubic through their two neighbours on each side; 0 at the ends.
std::vector<double> roughPart(const std::vector<double>& values) {
  std::vector<double> out(values.size(), 0.0);
  for (size_t k = 2; k + 2 < values.size(); ++k)
    out[k] = values[k] - (4.0 * (values[k - 1] + values[k + 1]) - values[k - 2] - values[k + 2]) / 6.0;
  return out;
}

/// A row's change of speed, with what may have made it.
struct Rows {
  Eigen::MatrixXd asRead, smooth;  ///< the drive in this row and before, then speed, direction and 1
  Eigen::VectorXd change;
};

/// How little a least squares fit leaves, as the logarithm of its likelihood.
double likelihood(const Eigen::MatrixXd& columns, const Eigen::VectorXd& response) {
  const double squares = leftByLeastSquares(columns, response).squaredNorm();
  return -0.5 * static_cast<double>(response.size()) * std::log(std::max(squares, 1e-300));
}

Rows rowsOf(const Track& track, const std::vector<double>& rough, double noise) {
  // Of noise in readings, this part of the rough part of two rows' mean is its best estimate.
  constexpr double part = 0.857;
  const std::vector<double>&x = track.position, &u = track.input;
  const double step = track.usualStep_s;
  std::vector<size_t> use;
  for (size_t k = lags + 2; k + 3 < track.rows(); ++k) {
    bool good = (x[k + 1] - x[k]) * (x[k] - x[k - 1]) > 0.0;
    for (size_t j = k - lags; good && j <= k + 1; ++j) {
      good = track.seen[j] != 0 && track.connected[j] != 0 && std::abs(rough[j]) < steps * noise &&
             std::abs(track.time[j] - track.time[j - 1] - step) < 0.2 * step;
    }
    if (good) use.push_back(k);
  }
  const auto count = static_cast<Eigen::Index>(use.size());
  const auto width = static_cast<Eigen::Index>(lags);
  Rows rows{Eigen::MatrixXd::Ones(count, width + 3), Eigen::MatrixXd::Ones(count, width + 3), Eigen::VectorXd(count)};
  for (Eigen::Index r = 0; r < count; ++r) {
    const size_t k = use[static_cast<size_t>(r)];
    for (size_t lag = 0; lag < lags; ++lag) {
      const size_t j = k - lag;
      const auto column = static_cast<Eigen::Index>(lag);
      rows.asRead(r, column) = 0.5 * (u[j - 1] + u[j]);
      rows.smooth(r, column) = rows.asRead(r, column) - 0.5 * part * (rough[j - 1] + rough[j]);
    }
    rows.asRead(r, width) = rows.smooth(r, width) = x[k + 1] - x[k - 1];
    rows.asRead(r, width + 1) = rows.smooth(r, width + 1) = x[k + 1] > x[k] ? 1.0 : -1.0;
    rows.change[r] = x[k + 1] - 2.0 * x[k] + x[k - 1];
  }
  return rows;
}

}  // namespace

double voltageReadingNoise(const Track& track) {
  if (track.drive != DriveInput::voltage || track.speedAlone()) return 0.0;
  const std::vector<double> rough = roughPart(track.input);
  std::vector<double> squares;
  squares.reserve(rough.size());
  for (const double one : rough) squares.push_back(one * one);
  // The median of a χ² with one degree of freedom is 0.4549; the rough part has 1 + Σw² = 1.944 of a reading's
  // variance.
  const double noise = squares.empty() ? 0.0 : std::sqrt(quantile(squares, 0.5) / (0.4549 * 1.944));
  const auto [low, high] = std::minmax_element(track.input.begin(), track.input.end());
  if (!(noise > leastNoise * (*high - *low))) return 0.0;
  const Rows rows = rowsOf(track, rough, noise);
  if (rows.change.size() < fewestRows) return 0.0;
  return likelihood(rows.smooth, rows.change) > likelihood(rows.asRead, rows.change) + clearly ? noise : 0.0;
}

}  // namespace breakaway
