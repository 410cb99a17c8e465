#include "diagnose/simulate/restart.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace breakaway {

namespace {

/// The current that flows at a given speed once L/R has passed.
double settledCurrent(const Physics& physics, const Track& track, size_t row, double velocity) {
  if (!physics.electrical || !track.connected[row]) return 0.0;
  return (track.input[row] - physics.backEmf * velocity) / physics.resistance;
}

struct Line {
  double position = 0.0;  ///< at the first row
  double slope = 0.0;
};

Line lineThrough(const Track& track, size_t first, size_t last) {
  double n = 0, st = 0, sx = 0, stt = 0, stx = 0;
  for (size_t k = first; k <= last; ++k) {
    if (!track.seen[k]) continue;
    const double t = track.time[k] - track.time[first], x = track.position[k] - track.position[first];
    n += 1;
    st += t;
    sx += x;
    stt += t * t;
    stx += t * x;
  }
  const double determinant = n * stt - st * st;
  if (n < 2 || determinant <= 0.0) return {track.position[first], 0.0};
  const double slope = (n * stx - st * sx) / determinant;
  return {track.position[first] + (sx - slope * st) / n, slope};
}

}  // namespace

void run(Stepper& stepper, const Track& track, size_t from, size_t to, MotionState& state) {
  for (size_t k = from; k < to; ++k) {
    stepper.advance(state, track.input[k], track.time[k + 1] - track.time[k], track.time[k], track.connected[k] != 0);
  }
}

MotionState restartState(Stepper& stepper, const Track& track, size_t row, double horizon_s) {
  size_t first = row;
  while (first > 0 && (track.time[row] - track.time[first - 1] <= horizon_s || row - first < 3)) --first;
  MotionState start{track.position[row], 0.0, 0.0};
  start.current = settledCurrent(stepper.physics(), track, row, 0.0);
  if (row - first < 3) return start;

  const size_t early = first + std::max<size_t>(2, (row - first) / 3);
  const Line line = lineThrough(track, first, early);
  const double length = track.time[row] - track.time[first];
  const double small = std::max(track.noise, 1e-12);
  Eigen::Vector3d unknown(line.position, line.slope, 0.0);  // position, velocity, load
  const Eigen::Vector3d nudge(small, small / length, stepper.physics().inertia * small / (length * length));
  const double ownLoad = stepper.physics().load;
  const auto beginAt = [&](const Eigen::Vector3d& at) {
    return MotionState{at[0], at[1], settledCurrent(stepper.physics(), track, first, at[1])};
  };
  for (int iteration = 0; iteration < 2; ++iteration) {
    std::array<Eigen::Vector3d, 4> at{unknown, unknown, unknown, unknown};
    std::array<MotionState, 4> states;
    for (int k = 0; k < 4; ++k) {
      if (k > 0) at[static_cast<size_t>(k)][k - 1] += nudge[k - 1];
      states[static_cast<size_t>(k)] = beginAt(at[static_cast<size_t>(k)]);
    }
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (size_t k = first; k <= row; ++k) {
      if (track.seen[k]) {
        Eigen::Vector3d slope;  // of the position by each unknown, in units of its nudge
        for (int j = 0; j < 3; ++j) slope[j] = states[static_cast<size_t>(j) + 1].position - states[0].position;
        normal += slope * slope.transpose();
        right += slope * (track.position[k] - states[0].position);
      }
      if (k == row) break;
      for (size_t j = 0; j < 4; ++j) {
        stepper.setLoad(ownLoad + at[j][2]);
        run(stepper, track, k, k + 1, states[j]);
      }
    }
    // Where friction swallows a nudge at once, the ridge keeps its step at zero.
    normal.diagonal().array() += 1e-9 * normal.diagonal().maxCoeff() + 1e-300;
    unknown += nudge.cwiseProduct(normal.ldlt().solve(right));
  }
  MotionState state = beginAt(unknown);
  stepper.setLoad(ownLoad + unknown[2]);
  run(stepper, track, first, row, state);
  stepper.setLoad(ownLoad);
  return state;
}

double restartVelocityNoise(const Track& track, double horizon_s) {
  const double step = track.time.back() / static_cast<double>(track.rows() - 1);
  const double rows = std::max(4.0, horizon_s / step + 1.0);
  return track.noise * std::sqrt(192.0 / rows) / (step * (rows - 1.0));
}

std::vector<size_t> restartRows(const Track& track, double window_s) {
  std::vector<size_t> rows{0};
  if (window_s <= 0.0) return rows;
  double k = 1.0;
  for (size_t row = 1; row < track.rows(); ++row) {
    if (track.time[row] < k * window_s - 1e-9) continue;
    rows.push_back(row);
    while (track.time[row] >= k * window_s - 1e-9) k += 1.0;
  }
  return rows;
}

}  // namespace breakaway
