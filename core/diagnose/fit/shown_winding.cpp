#include "diagnose/fit/shown_winding.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

constexpr double shortestWinding_s = 2e-5;  ///< time constant of a winding
constexpr size_t fewestWindingRows = 5;     ///< of a span
constexpr size_t fewestSpans = 14;
constexpr double span_s = 0.01;  ///< at least
constexpr size_t mostWindingRows = 40'000;
constexpr double cluster_s = 1.0;
constexpr double clearlyLessLeft = 0.8;  ///< of what fewer columns leave
constexpr double windingErrors = 3.0;    ///< an interval, on each side
constexpr double surest = 1e-3;          ///< of a constant: what is known of rows and gains
constexpr double clearOfNoise = 3.0;     ///< currents whose sign is known, in standard deviations of their noise

/// The two electrical channels of a track, whichever of them drives; empty where one was not recorded.
struct Channels {
  const std::vector<double>&voltage, &current;
  explicit Channels(const Track& track)
      : voltage(track.drive == DriveInput::current ? track.voltage : track.input),
        current(track.drive == DriveInput::current ? track.input : track.current) {}
  bool both() const { return !voltage.empty() && !current.empty(); }
};

enum WindingColumn { volts, way, change, step, lost, zero, response, columns };
using WindingRow = Eigen::Matrix<double, columns, 1>;
constexpr Eigen::Index plain = 4, withBridge = 6;  ///< columns

/// Calls `act` with the columns of each span of rows: the voltage's integral, the way, by how much the current changes,
/// the integrals of its sign and of one, and its own; and with the time at which the span begins.
template <typename Act>
void eachSpan(const Track& track, Act act) {
  const Channels channels(track);
  const double noise = track.drive == DriveInput::current ? track.inputNoise : track.currentNoise;
  const auto known = [&](size_t k) {
    return track.connected[k] != 0 && std::isfinite(channels.current[k]) && std::isfinite(channels.voltage[k]);
  };
  const size_t rows = std::min(track.rows(), mostWindingRows);
  for (size_t first = 0; first + 1 < rows;) {
    WindingRow sums = WindingRow::Zero();
    size_t k = first;
    for (; k + 1 < rows && known(k) && known(k + 1); ++k) {
      const double i = channels.current[k], dt = track.time[k + 1] - track.time[k];
      const double sign = i / std::max(std::abs(i) + clearOfNoise * noise, 1e-300);
      const double moved = track.speedAlone() ? dt * 0.5 * (track.motion.velocity[k] + track.motion.velocity[k + 1])
                                              : track.position[k + 1] - track.position[k];
      sums += (WindingRow() << dt * channels.voltage[k], moved, channels.current[k + 1] - i,
               channels.voltage[k + 1] - channels.voltage[k], dt * sign, dt, dt * i)
                  .finished();
      if (k + 1 - first >= fewestWindingRows && track.time[k + 1] - track.time[first] >= span_s) {
        act(sums, track.time[first]);
        sums.setZero();
        first = k + 1;
      }
    }
    first = k + 1;
  }
}

/// Least squares of the current's integral on the first `width` columns.
struct WindingBalance {
  Eigen::Matrix<double, columns, columns> products = Eigen::Matrix<double, columns, columns>::Zero();
  size_t spans = 0;

  explicit WindingBalance(const std::vector<Track>& tracks) {
    for (const Track& track : tracks) {
      eachSpan(track, [this](const WindingRow& row, double) {
        products += row * row.transpose();
        ++spans;
      });
    }
  }
  Eigen::VectorXd solution(Eigen::Index width) const { return solved(products, width); }
  /// One over a column's coefficient, by the regression of that column on the current and the others.
  double inverse(WindingColumn of, Eigen::Index width) const {
    Eigen::Matrix<double, columns, columns> exchanged = products;
    exchanged.row(of).swap(exchanged.row(response));
    exchanged.col(of).swap(exchanged.col(response));
    return solved(exchanged, width)[of];
  }
  double left(Eigen::Index width) const {
    return products(response, response) - solution(width).dot(products.col(response).head(width));
  }

  /// Of the columns: those in which they are alike.
  static Eigen::VectorXd unitsOf(const Eigen::Matrix<double, columns, columns>& products, Eigen::Index width) {
    return products.diagonal().head(width).cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  }

 private:
  static Eigen::VectorXd solved(const Eigen::Matrix<double, columns, columns>& products, Eigen::Index width) {
    const Eigen::VectorXd unit = unitsOf(products, width);
    const Eigen::MatrixXd scaled = unit.asDiagonal() * products.topLeftCorner(width, width) * unit.asDiagonal();
    return unit.cwiseProduct(solveSymmetric(scaled, unit.cwiseProduct(products.col(response).head(width))));
  }
};

/// Of the solution, errors of one second taken as one.
Eigen::MatrixXd covarianceOf(const WindingBalance& balance, Eigen::Index width, const std::vector<Track>& tracks) {
  const Eigen::VectorXd solution = balance.solution(width);
  const Eigen::VectorXd unit = WindingBalance::unitsOf(balance.products, width);
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(width, width);
  for (const Track& track : tracks) {
    Eigen::VectorXd score = Eigen::VectorXd::Zero(width);
    double begin_s = track.time.front();
    eachSpan(track, [&](const WindingRow& row, double at_s) {
      if (at_s - begin_s >= cluster_s) {
        spread += score * score.transpose();
        score.setZero();
        begin_s = at_s;
      }
      score += (row[response] - row.head(width).dot(solution)) * unit.cwiseProduct(row.head(width));
    });
    spread += score * score.transpose();
  }
  const Eigen::MatrixXd inverse =
      inverseOf(unit.asDiagonal() * balance.products.topLeftCorner(width, width) * unit.asDiagonal());
  return unit.asDiagonal() * inverse * spread * inverse * unit.asDiagonal();
}

}  // namespace

std::optional<ShownWinding> shownWinding(const std::vector<Track>& tracks) {
  if (tracks.empty() || !std::all_of(tracks.begin(), tracks.end(), [](const Track& one) {
        return one.drive != DriveInput::torque && Channels(one).both();
      }))
    return {};
  const WindingBalance balance(tracks);
  if (balance.spans < fewestSpans) return {};
  const Eigen::Index width = balance.left(withBridge) < clearlyLessLeft * balance.left(plain) ? withBridge : plain;
  const Eigen::VectorXd perVolt = balance.solution(width);  // 1/R, −Ke/R, −L/R and a part of a row
  const Eigen::MatrixXd covariance = covarianceOf(balance, width, tracks);
  if (!perVolt.allFinite() || perVolt[volts] == 0.0 || !covariance.allFinite()) return {};
  ShownWinding shown;
  const double ohm = 1.0 / perVolt[volts];
  shown.resistance_ohm = {ohm, std::sqrt(std::max(0.0, covariance(volts, volts))) * ohm * ohm};
  // All channels are noisy: a current that is as good as its own sign needs no voltage, and a speed that hardly rises
  // above its noise shows hardly any back-EMF. The truth lies between the regressions of the one on the other (R.
  // Frisch, 'Statistical confluence analysis', 1934).
  const auto widen = [&](Estimate& one, WindingColumn of) {
    const double ratio = balance.inverse(of, width) * perVolt[of];
    if (ratio > 0.0)
      one.standardError = std::max(one.standardError, std::abs(std::log(ratio) * one.value) / windingErrors);
  };
  widen(shown.resistance_ohm, volts);
  const auto overFirst = [&](WindingColumn of) {  // the ratio of a coefficient to that of the voltage, turned
    const double value = -perVolt[of] * ohm;
    const Eigen::Vector2d slopes(value * ohm, ohm);
    Eigen::Matrix2d both;
    both << covariance(volts, volts), covariance(volts, of), covariance(of, volts), covariance(of, of);
    return Estimate{value, std::sqrt(std::max(0.0, slopes.dot(both * slopes)))};
  };
  shown.backEmf = overFirst(way);
  widen(shown.backEmf, way);
  for (Estimate* one : {&shown.resistance_ohm, &shown.backEmf})
    one->standardError = std::hypot(one->standardError, surest * one->value);
  // Within a row the current may change at its begin or at its end: L and up to a row's R come together.
  const Estimate together = overFirst(change);
  const double least = shortestWinding_s * std::abs(ohm), row = longestRow_s(tracks) * std::abs(ohm);
  const double doubt = windingErrors * together.standardError;
  shown.inductance_H = std::max(least, together.value - 0.5 * row);
  shown.leastInductance_H = std::max(least, together.value - row - doubt);
  shown.mostInductance_H = std::max(least, together.value + doubt);
  shown.left = balance.left(width) / std::max(balance.products(response, response), 1e-300);
  return shown;
}

}  // namespace breakaway
