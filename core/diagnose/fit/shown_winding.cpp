#include "diagnose/fit/shown_winding.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr double shortest_s = 2e-5, lag = 1.3;  ///< of the time constants that are tried, and their ratio
constexpr int lags = 32;                        ///< up to 70 ms
constexpr size_t mostRows = 40'000;
constexpr double cluster_s = 1.0;
constexpr double clearlyLess = 0.8;     ///< of what another lag, or what fewer columns leave
constexpr double standardErrors = 3.0;  ///< an interval, on each side
constexpr double clearOfNoise = 3.0;    ///< currents whose sign is known, in standard deviations of their noise

/// The two electrical channels of a track, whichever of them drives; empty where one was not recorded.
struct Channels {
  const std::vector<double>&voltage, &current;
  explicit Channels(const Track& track)
      : voltage(track.drive == DriveInput::current ? track.voltage : track.input),
        current(track.drive == DriveInput::current ? track.input : track.current) {}
  bool both() const { return !voltage.empty() && !current.empty(); }
};

enum Column { volts, speed, lost, zero, response, columns };
using Row = Eigen::Matrix<double, columns, 1>;
constexpr Eigen::Index plain = 2, withBridge = 4;  ///< columns

/// Calls `act` with the columns of each row that has them, voltage and speed lagged, and the row.
template <typename Act>
void eachRow(const Track& track, double time_s, Act act) {
  const Channels channels(track);
  const double noise = track.drive == DriveInput::current ? track.inputNoise : track.currentNoise;
  double u = channels.voltage.front(), velocity = track.motion.velocity.front();
  for (size_t k = 0; k + 1 < std::min(track.rows(), mostRows); ++k) {
    const double i = channels.current[k];
    if (track.connected[k] != 0 && std::isfinite(i) && std::isfinite(u)) {
      const double sign = i / std::max(std::abs(i) + clearOfNoise * noise, 1e-300);
      act((Row() << u, velocity, sign, 1.0, i).finished(), k);
    }
    const double keep = std::exp(-(track.time[k + 1] - track.time[k]) / time_s);
    if (const double acts = channels.voltage[k]; std::isfinite(acts))
      u = std::isfinite(u) ? acts + (u - acts) * keep : acts;
    velocity = track.motion.velocity[k] + (velocity - track.motion.velocity[k]) * keep;
  }
}

/// Least squares of the current on the first `width` columns.
struct Balance {
  Eigen::Matrix<double, columns, columns> products = Eigen::Matrix<double, columns, columns>::Zero();
  double time_s = shortest_s;

  Balance(const std::vector<Track>& tracks, double lag_s) : time_s(lag_s) {
    for (const Track& track : tracks)
      eachRow(track, time_s, [this](const Row& row, size_t) { products += row * row.transpose(); });
  }
  Eigen::VectorXd solution(Eigen::Index width) const {
    return products.topLeftCorner(width, width).ldlt().solve(products.col(response).head(width));
  }
  /// One over a column's coefficient, by the regression of that column on the current and the others.
  double inverse(Column of, Eigen::Index width) const {
    Eigen::Matrix<double, columns, columns> exchanged = products;
    exchanged.row(of).swap(exchanged.row(response));
    exchanged.col(of).swap(exchanged.col(response));
    return exchanged.topLeftCorner(width, width).ldlt().solve(exchanged.col(response).head(width))[of];
  }
  double left(Eigen::Index width) const {
    return products(response, response) - solution(width).dot(products.col(response).head(width));
  }
};

/// Of the solution, errors of one second taken as one.
Eigen::MatrixXd covarianceOf(const Balance& balance, Eigen::Index width, const std::vector<Track>& tracks) {
  const Eigen::VectorXd solution = balance.solution(width);
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(width, width);
  for (const Track& track : tracks) {
    Eigen::VectorXd score = Eigen::VectorXd::Zero(width);
    double begin_s = track.time.front();
    eachRow(track, balance.time_s, [&](const Row& row, size_t k) {
      if (track.time[k] - begin_s >= cluster_s) {
        spread += score * score.transpose();
        score.setZero();
        begin_s = track.time[k];
      }
      score += (row[response] - row.head(width).dot(solution)) * row.head(width);
    });
    spread += score * score.transpose();
  }
  const Eigen::MatrixXd inverse = balance.products.topLeftCorner(width, width).inverse();
  return inverse * spread * inverse;
}

}  // namespace

std::optional<ShownWinding> shownWinding(const std::vector<Track>& tracks) {
  if (tracks.empty() || !std::all_of(tracks.begin(), tracks.end(), [](const Track& one) {
        return one.drive != DriveInput::torque && Channels(one).both();
      }))
    return {};
  std::optional<Balance> best, usual;  // of all, and of those whose signs are right
  std::vector<Balance> all;
  all.reserve(lags);
  double time_s = shortest_s;
  for (int k = 0; k < lags; ++k, time_s *= lag) {
    const Balance& balance = all.emplace_back(tracks, time_s);
    const Eigen::VectorXd perVolt = balance.solution(plain);
    if (!best || balance.left(plain) < best->left(plain)) best = balance;
    const bool right = perVolt[volts] > 0.0 && perVolt[speed] < 0.0;
    if (right && (!usual || balance.left(plain) < usual->left(plain))) usual = balance;
  }
  if (usual && best->left(plain) > clearlyLess * usual->left(plain)) best = usual;
  const Eigen::Index width = best->left(withBridge) < clearlyLess * best->left(plain) ? withBridge : plain;
  const Eigen::VectorXd perVolt = best->solution(width);  // 1/R, −Ke/R
  const Eigen::MatrixXd covariance = covarianceOf(*best, width, tracks);
  if (!perVolt.allFinite() || perVolt[volts] == 0.0 || !covariance.allFinite()) return {};
  ShownWinding shown;
  const double ohm = 1.0 / perVolt[volts];
  shown.resistance_ohm = {ohm, std::sqrt(std::max(0.0, covariance(volts, volts))) * ohm * ohm};
  // All channels are noisy: a current that is as good as its own sign needs no voltage, and a speed that hardly rises
  // above its noise shows hardly any back-EMF. The truth lies between the regressions of the one on the other (R.
  // Frisch, 'Statistical confluence analysis', 1934).
  const auto widen = [&](Estimate& one, Column of) {
    const double ratio = best->inverse(of, width) * perVolt[of];
    if (ratio > 0.0)
      one.standardError = std::max(one.standardError, std::abs(std::log(ratio) * one.value) / standardErrors);
  };
  widen(shown.resistance_ohm, volts);
  const Eigen::Vector2d slopes(perVolt[speed] * ohm * ohm, -ohm);
  const double variance = slopes.dot(covariance.topLeftCorner<plain, plain>() * slopes);
  shown.backEmf = {-perVolt[speed] * ohm, std::sqrt(std::max(0.0, variance))};
  widen(shown.backEmf, speed);
  shown.inductance_H = best->time_s * ohm;
  // Rows much longer than the lag hardly show it.
  const auto alike = [&](const Balance& one) { return clearlyLess * one.left(width) < best->left(width); };
  shown.leastInductance_H = std::find_if(all.begin(), all.end(), alike)->time_s * ohm;
  shown.mostInductance_H = std::find_if(all.rbegin(), all.rend(), alike)->time_s * ohm;
  shown.left = best->left(width) / std::max(best->products(response, response), 1e-300);
  return shown;
}

}  // namespace breakaway
