#include "diagnose/search/voltage_balance.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

constexpr size_t partsOfWindow = 4, fewestWindows = 8, fewestVoltageRows = 8;
constexpr double clearOfNoise = 5.0;  ///< standard deviations

enum Column { resistance, offset, backEmf, inductance, deadTime, columns };
using Row = Eigen::Matrix<double, 1, columns>;
using Square = Eigen::Matrix<double, columns, columns>;

struct Balance {
  std::vector<Row> rows;
  std::vector<double> voltages;  ///< V s
  std::vector<size_t> windows;   ///< of each row
  void add(const Track& track, size_t first, size_t last, size_t window);
};

void Balance::add(const Track& track, size_t first, size_t last, size_t window) {
  Row row = Row::Zero();
  double voltage = 0.0;
  for (size_t k = first; k < last; ++k) {
    if (track.connected[k] == 0 || !std::isfinite(track.voltage[k])) return;
    const double dt = track.time[k + 1] - track.time[k], current = track.input[k];
    voltage += track.voltage[k] * dt;
    row[resistance] += current * dt;
    row[offset] += dt;
    row[deadTime] += current == 0.0 ? 0.0 : std::copysign(dt, current);
  }
  if (!track.placed(first) || !track.placed(last)) return;
  row[backEmf] = track.position[last] - track.position[first];
  row[inductance] = track.input[last] - track.input[first];
  rows.push_back(row);
  voltages.push_back(voltage);
  windows.push_back(window);
}

}  // namespace

std::optional<SensorOffset> sensorOffset(const std::vector<Track>& tracks, const std::vector<Window>& windows) {
  Balance balance;
  for (size_t w = 0; w < windows.size(); ++w) {
    const Track& track = tracks[windows[w].track];
    if (track.voltage.empty()) return {};
    const size_t rows = (windows[w].last - windows[w].first) / partsOfWindow;
    if (rows < fewestVoltageRows) return {};
    for (size_t part = 0; part < partsOfWindow; ++part)
      balance.add(track, windows[w].first + part * rows, windows[w].first + (part + 1) * rows, w);
  }
  if (balance.rows.size() < partsOfWindow * fewestWindows) return {};
  Square products = Square::Zero();
  Row right = Row::Zero();
  for (size_t k = 0; k < balance.rows.size(); ++k) {
    products += balance.rows[k].transpose() * balance.rows[k];
    right += balance.voltages[k] * balance.rows[k];
  }
  const Row unit = products.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse().transpose();
  const Square scale = unit.transpose().asDiagonal();
  const Square inverse = scale * Square(inverseOf(scale * products * scale + 1e-12 * Square::Identity())) * scale;
  const Row solution = right * inverse;
  // Windows as clusters: errors within one hang together.
  Square spread = Square::Zero();
  Row cluster = Row::Zero();
  for (size_t k = 0; k < balance.rows.size(); ++k) {
    cluster += (balance.voltages[k] - balance.rows[k].dot(solution)) * balance.rows[k];
    if (k + 1 < balance.rows.size() && balance.windows[k + 1] == balance.windows[k]) continue;
    spread += cluster.transpose() * cluster;
    cluster.setZero();
  }
  const Square covariance = inverse * spread * inverse;
  const double ohm = solution[resistance];
  if (!(ohm > clearOfNoise * std::sqrt(covariance(resistance, resistance)))) return {};
  // c = −offset / R; its slopes by both.
  Row slopes = Row::Zero();
  slopes[offset] = -1.0 / ohm;
  slopes[resistance] = solution[offset] / (ohm * ohm);
  return SensorOffset{-solution[offset] / ohm, std::sqrt(slopes * covariance * slopes.transpose())};
}

}  // namespace breakaway
