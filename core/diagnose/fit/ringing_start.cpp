#include "diagnose/fit/ringing_start.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "dense/dense_solve.h"
#include "diagnose/simulate/physics.h"
#include "motor/bench.h"

namespace breakaway {

namespace {

// The columns of a row: voltages of this row and of those before, the direction, one, the two speeds before, its own.
constexpr Eigen::Index voltages = 12, direction = voltages, evenly = voltages + 1, speeds = voltages + 2,
                       itsSpeed = voltages + 4, allColumns = voltages + 5;
constexpr Eigen::Index actingVoltages = 4;  ///< one more than a whole row asks for: one may act late in its row
constexpr double evenStep = 0.05;           ///< of the usual one, by which a step may differ
constexpr double leastCounts = 2.0;         ///< per row, of a motion whose direction is sure
constexpr size_t fewestRows = 100;          ///< of the recursion
constexpr double slowRinging_rows = 10;     ///< rows per radian: the inverse model sees what is slower
constexpr double quickestRinging_Hz = 500.0;
/// Mean of two poles on the positive axis over the root of their product, up to which noise may have parted a pair:
/// what rings about once a row, or twice, looks like a double one.
constexpr double aPairStill = 1.1;

using Products = Eigen::Matrix<double, allColumns, allColumns>;

/// Adds the products of a track's columns. Returns how many rows had some.
size_t addRows(const Track& track, Products& products) {
  const double step = track.usualStep_s;
  const bool alone = track.speedAlone();
  const double least = alone ? 3.0 * track.speedNoise : leastCounts * std::sqrt(12.0) * track.quantisation / step;
  const auto speed = [&](size_t k) {
    return alone ? track.speed[k] : (track.position[k + 1] - track.position[k]) / (track.time[k + 1] - track.time[k]);
  };
  const auto usable = [&](size_t k) {
    return track.connected[k] != 0 && track.seen[k] != 0 && track.seen[k + 1] != 0 && std::isfinite(track.input[k]) &&
           std::abs(track.time[k + 1] - track.time[k] - step) < evenStep * step;
  };
  size_t rows = 0, known = 0, oneWay = 0;
  double way = 0.0;
  for (size_t k = 0; k + 1 < track.rows(); ++k) {
    if (!usable(k)) {
      known = oneWay = 0;
      continue;
    }
    const double v = speed(k);
    const double sign = std::abs(v) > least ? std::copysign(1.0, v) : 0.0;
    oneWay = sign == 0.0 ? 0 : sign == way ? oneWay + 1 : 1;
    way = sign;
    if (++known < static_cast<size_t>(voltages) || oneWay < static_cast<size_t>(actingVoltages)) continue;
    Eigen::Matrix<double, allColumns, 1> row;
    for (Eigen::Index back = 0; back < voltages; ++back) row[back] = track.input[k - static_cast<size_t>(back)];
    row.tail<allColumns - voltages>() << sign, 1.0, speed(k - 1), speed(k - 2), v;
    products += row * row.transpose();
    ++rows;
  }
  return rows;
}

struct Recursion {
  double damping = 0.0;   ///< 1/s, −σ of both poles
  double rings = 0.0;     ///< rad/s, the slowest that rows can mean
  double gain = 0.0;      ///< speed per volt
  double friction = 0.0;  ///< speed lost by it
};

/// The recursion's coefficients: two of speeds, those of the voltages that act, of the direction and of one. Speeds are
/// uncertain by a reading's noise, which would draw the poles towards the origin: what all voltages foretell of them
/// stands in their place (two-stage least squares; T. Söderström and P. Stoica, 'Instrumental variable methods for
/// system identification', 1983).
Eigen::VectorXd coefficients(const Products& sums) {
  const Eigen::Matrix<double, allColumns, 1> size = sums.diagonal().cwiseSqrt().cwiseMax(1e-300);
  const Products products = size.cwiseInverse().asDiagonal() * sums * size.cwiseInverse().asDiagonal();
  std::vector<Eigen::Index> regressors{speeds, speeds + 1};
  for (Eigen::Index j = 0; j < actingVoltages; ++j) regressors.push_back(j);
  regressors.insert(regressors.end(), {direction, evenly});
  const Eigen::Index instruments = speeds;
  const Eigen::MatrixXd seen = products(Eigen::seqN(0, instruments), regressors);
  const Eigen::MatrixXd foretold = leastNorms(products.topLeftCorner(instruments, instruments), seen);
  const Eigen::MatrixXd normal = seen.transpose() * foretold;
  const Eigen::VectorXd right = foretold.transpose() * products.col(itsSpeed).head(instruments);
  Eigen::VectorXd found = leastNorm(normal, right);
  for (Eigen::Index j = 0; j < found.size(); ++j) found[j] *= size[itsSpeed] / size[regressors[static_cast<size_t>(j)]];
  return found;
}

std::optional<Recursion> recursionOf(const std::vector<Track>& tracks, double step_s) {
  Products products = Products::Zero();
  size_t rows = 0;
  for (const Track& track : tracks) rows += addRows(track, products);
  if (rows < fewestRows) return std::nullopt;
  const Eigen::VectorXd found = coefficients(products);
  const double product = -found[1];  // of both poles in z
  if (!(product > 0.0) || product >= 1.0) return std::nullopt;
  const double cosine = found[0] / (2.0 * std::sqrt(product));
  if (cosine >= aPairStill) return std::nullopt;  // two poles that don't ring
  Recursion out;
  out.damping = -0.5 * std::log(product) / step_s;
  out.rings = std::acos(std::clamp(cosine, -1.0, 1.0)) / step_s;
  const double still = 1.0 - found[0] - found[1];
  out.gain = found.segment(2, actingVoltages).sum() / still;
  out.friction = -found[2 + actingVoltages] / still;
  return out;
}

void set(Model& model, const std::vector<std::string>& held, const char* name, double value) {
  if (std::find(held.begin(), held.end(), name) != held.end() || !(value > 0.0)) return;
  for (Parameter& one : model.base) {
    if (one.name == name) {
      one = {name, value, value, value};
      return;
    }
  }
  model.base.push_back({name, value, value, value});
}

}  // namespace

std::vector<Model> ringingStarts(const Model& start, const std::vector<Track>& tracks,
                                 const std::vector<std::string>& held) {
  const Physics physics = physicsOf(start);
  if (!physics.electrical || start.servo || tracks.empty()) return {};
  const double step_s = tracks.front().usualStep_s;
  for (const Track& track : tracks) {
    if (std::abs(track.usualStep_s - step_s) > evenStep * step_s) return {};
  }
  const auto seen = recursionOf(tracks, step_s);
  if (!seen || !(seen->gain > 0.0)) return {};
  const MotorNames& names = motorNames(start.axis);
  const auto isHeld = [&held](const char* name) { return std::find(held.begin(), held.end(), name) != held.end(); };
  const double stiffness = physics.torqueConstant / seen->gain;  // R B + Kt Ke
  const double fold = 2.0 * std::numbers::pi / step_s;
  std::vector<Model> starts;
  for (const double rings : {seen->rings, fold - seen->rings, fold + seen->rings, 2.0 * fold - seen->rings}) {
    if (rings > 2.0 * std::numbers::pi * quickestRinging_Hz || rings * step_s * slowRinging_rows < 1.0) continue;
    const double product = stiffness / (rings * rings + seen->damping * seen->damping);  // L J
    double inductance = physics.resistance / (2.0 * seen->damping);
    if (isHeld(names.inductance)) inductance = physics.inductance;
    if (isHeld(names.inertia)) inductance = product / start.baseValue(names.inertia).value_or(1.0);
    starts.push_back(start);
    set(starts.back(), held, names.inductance, inductance);
    set(starts.back(), held, names.inertia, product / inductance);
    set(starts.back(), held, names.viscous,
        (stiffness - physics.torqueConstant * physics.backEmf) / physics.resistance);
    set(starts.back(), held, names.coulomb, seen->friction * stiffness / physics.resistance);
  }
  return starts;
}

}  // namespace breakaway
