#include "diagnose/fit/motion.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "diagnose/fit/inverse_rows.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr double restSpan_s = 0.05;

/// 1 where the position stays within `reach` over the span around a row.
std::vector<char> restsOf(const Track& track, double reach) {
  const size_t n = track.rows();
  std::vector<char> resting(n, 0);
  std::deque<size_t> lowest, highest;
  size_t first = 0;
  for (size_t k = 0; k < n; ++k) {
    while (!lowest.empty() && track.position[lowest.back()] >= track.position[k]) lowest.pop_back();
    while (!highest.empty() && track.position[highest.back()] <= track.position[k]) highest.pop_back();
    lowest.push_back(k);
    highest.push_back(k);
    while (track.time[k] - track.time[first] > restSpan_s) {
      if (lowest.front() == first) lowest.pop_front();
      if (highest.front() == first) highest.pop_front();
      ++first;
    }
    const bool whole = track.time[k] - track.time[first] > 0.8 * restSpan_s && k - first >= 3;
    const bool still = track.position[highest.front()] - track.position[lowest.front()] <= reach;
    if (whole && still)
      std::fill(resting.begin() + static_cast<std::ptrdiff_t>(first),
                resting.begin() + static_cast<std::ptrdiff_t>(k) + 1, 1);
  }
  return resting;
}

double between(const std::vector<double>& values, double at) {
  const double inside = std::clamp(at, 0.0, static_cast<double>(values.size() - 1));
  const auto k = std::min(static_cast<size_t>(inside), values.size() - 2);
  const double part = inside - static_cast<double>(k);
  return (1.0 - part) * values[k] + part * values[k + 1];
}

}  // namespace

Motion motionOf(const Track& track) {
  const InverseRows rows = inverseRows(track);
  const size_t n = track.rows();
  Motion motion;
  motion.velocityNoise = rows.velocityNoise;
  motion.velocity.resize(n);
  motion.acceleration.resize(n);
  if (rows.time.size() >= 2) {
    const std::vector<double> time = withoutPauses(track, rows.step_s);
    for (size_t k = 0; k < n; ++k) {
      const double at = time[k] / rows.step_s;
      motion.velocity[k] = between(rows.velocity, at);
      motion.acceleration[k] = between(rows.acceleration, at);
    }
  }
  motion.resting = restsOf(track, 4.0 * track.noise);
  motion.rest_s.resize(n);
  motion.turned.resize(n);
  motion.way.resize(n);
  double rest = 0.0, turned = n > 0 ? track.position[0] : 0.0, way = 0.0;
  bool rested = false, sinceRest = false;
  for (size_t k = 0; k < n; ++k) {
    const double v = motion.velocity[k], s = v > 0.0 ? 1.0 : -1.0;
    if (motion.resting[k]) {
      sinceRest = false;
      rest = (rested ? rest : 0.0) + (k > 0 ? track.time[k] - track.time[k - 1] : 0.0);
    } else if (std::abs(v) > 4.0 * rows.velocityNoise && s != way) {
      if (way != 0.0 && sinceRest) rest = 0.0;  // it turned without a rest
      sinceRest = true;
      if (way == 0.0) std::fill_n(motion.way.begin(), k, s);
      way = s;
      turned = track.position[k];
    }
    rested = motion.resting[k] != 0;
    motion.rest_s[k] = rest;
    motion.turned[k] = turned;
    motion.way[k] = way;
  }
  return motion;
}

std::vector<MotionState> hiddenStates(const Model& model, const std::vector<Track>& tracks,
                                      const std::vector<Window>& windows) {
  std::vector<MotionState> states(windows.size());
  for (size_t t = 0; t < tracks.size(); ++t) {
    const Track& track = tracks[t];
    Stepper stepper(physicsOf(model), *termsOf(model, track.name));
    const Physics& p = stepper.physics();
    const Motion& motion = track.motion;
    std::vector<std::pair<size_t, size_t>> wanted;  // row, window
    for (size_t w = 0; w < windows.size(); ++w) {
      if (windows[w].track == t) wanted.emplace_back(windows[w].first, w);
    }
    if (motion.velocity.empty() || wanted.empty()) continue;
    std::sort(wanted.begin(), wanted.end());
    MotionState state;
    size_t done = 0;
    const auto take = [&](size_t row) {
      state.rest_s = motion.rest_s[row];
      state.turned = motion.turned[row];
      state.way = motion.way[row];
      state.velocity = motion.resting[row] ? 0.0 : motion.velocity[row];
    };
    if (stepper.remembersLong()) {
      for (size_t row = 0; row < track.rows() && done < wanted.size(); ++row) {
        for (; done < wanted.size() && wanted[done].first == row; ++done) {
          take(row);
          states[wanted[done].second] = state;
        }
        if (row + 1 == track.rows()) break;
        take(row);
        state.position = track.position[row];
        const MotionState before = state;
        state.position = track.position[row + 1];
        state.velocity = motion.resting[row + 1] ? 0.0 : motion.velocity[row + 1];
        state.acceleration = motion.acceleration[row + 1];
        const double u = track.input[row], dt = track.time[row + 1] - track.time[row];
        if (p.electrical) {
          stepper.setSupply(track.supplyAt(row));
          const double lost = stepper.losesVoltage()
                                  ? stepper.lostVoltage(before, u, before.position, state.velocity, track.time[row])
                                  : 0.0;
          const double settled = track.connected[row] ? (u - lost - p.backEmf * state.velocity) / p.resistance : 0.0;
          const double keep = p.inductance > 0.0 ? std::exp(-dt * p.resistance / p.inductance) : 0.0;
          state.current = settled + (before.current - settled) * keep;
        }
        stepper.keepHistory(state, before, u, dt, track.time[row + 1]);
      }
      continue;
    }
    for (const auto& [row, w] : wanted) {
      take(row);
      states[w] = state;
    }
  }
  return states;
}

}  // namespace breakaway
