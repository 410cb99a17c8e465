#include "diagnose/restart.h"

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
  double x = line.position, v = line.slope;
  const double length = track.time[row] - track.time[first];
  const double nudge = std::max(1e-6 * std::abs(v), 1e-3 * std::max(track.noise, 1e-12) / length);
  const auto beginAt = [&](double position, double velocity) {
    return MotionState{position, velocity, settledCurrent(stepper.physics(), track, first, velocity)};
  };
  for (int iteration = 0; iteration < 2; ++iteration) {
    MotionState nominal = beginAt(x, v), faster = beginAt(x, v + nudge);
    double n = 0, sj = 0, sjj = 0, sr = 0, sjr = 0;
    for (size_t k = first; k <= row; ++k) {
      if (track.seen[k]) {
        const double j = (faster.position - nominal.position) / nudge;
        const double r = track.position[k] - nominal.position;
        n += 1;
        sj += j;
        sjj += j * j;
        sr += r;
        sjr += j * r;
      }
      if (k == row) break;
      run(stepper, track, k, k + 1, nominal);
      run(stepper, track, k, k + 1, faster);
    }
    const double ridge = 1e-6 * n * length * length;
    const double determinant = n * (sjj + ridge) - sj * sj;
    if (n < 3 || determinant <= 0.0) break;
    const double dv = (n * sjr - sj * sr) / determinant;
    x += (sr - sj * dv) / n;
    v += dv;
  }
  MotionState state = beginAt(x, v);
  run(stepper, track, first, row, state);
  return state;
}

double restartVelocityNoise(const Track& track, double horizon_s) {
  const double step = track.time.back() / static_cast<double>(track.rows() - 1);
  const double rows = std::max(4.0, horizon_s / step + 1.0);
  return track.noise * std::sqrt(12.0 / rows) / (step * (rows - 1.0));
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
