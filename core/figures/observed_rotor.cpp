#include "figures/observed_rotor.h"

#include <cmath>

#include "base/numbers.h"
#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr double stiffness_rad_per_s = 60.0;  // of the drive that holds the speed, by the true speed
constexpr double takenOff = 0.9;              // of the load; the rest makes the speed wander, as it does on a rig

/// How long before the end of a tick the motion from `angle` with `velocity` and `acceleration` passed `edge`.
double sinceCrossing(double edge, double angle, double velocity, double acceleration, double tick_s) {
  double crossing_s = 0.5 * tick_s;
  for (int k = 0; k < 8; ++k) {
    const double off = angle + crossing_s * (velocity + 0.5 * acceleration * crossing_s) - edge;
    const double slope = velocity + acceleration * crossing_s;
    if (slope == 0.0) break;
    crossing_s -= off / slope;
  }
  return tick_s - std::fmin(tick_s, std::fmax(0.0, crossing_s));
}

}  // namespace

std::vector<ObservedTick> observeRotor(const ObservedRotorOptions& options) {
  const double q = options.count_rad, T = options.tick_s, J = options.inertia_kg_m2;
  const double Kt = options.torqueConstant_Nm_per_A;
  Random random(options.seed);
  double angle = 1000.0 * q * random.uniform(), velocity = options.speed_rad_per_s, load = 0.0, flowed = 0.0;
  double edge = std::floor(angle / q) * q, sinceEdge = T;
  std::vector<ObservedTick> ticks;
  const auto count = static_cast<size_t>(options.duration_s / T);
  ticks.reserve(count);
  for (size_t k = 0; k < count; ++k) {
    ObservedTick tick;
    tick.angle_rad = (std::floor(angle / q) + 0.5) * q;
    tick.edge_rad = edge;
    tick.sinceEdge_s = std::round(sinceEdge / options.timerStep_s) * options.timerStep_s;
    tick.current_A = flowed + options.currentNoise_A * random.normal();
    tick.velocity_rad_per_s = velocity;
    const double phase = turn_rad * options.swing_Hz * static_cast<double>(k) * T;
    const double wanted = options.speed_rad_per_s + options.swing_rad_per_s * std::sin(phase);
    flowed = (takenOff * load + J * stiffness_rad_per_s * (wanted - velocity)) / Kt;
    const double acceleration = (Kt * flowed - load) / J;
    const double before = std::floor(angle / q);
    const double start = angle;
    angle += T * (velocity + 0.5 * acceleration * T);
    const double after = std::floor(angle / q);
    sinceEdge += T;
    if (after != before) {
      edge = (after > before ? after : after + 1.0) * q;
      sinceEdge = sinceCrossing(edge, start, velocity, acceleration, T);
    }
    velocity += acceleration * T;
    load += options.loadWalk_Nm_per_sqrt_s * std::sqrt(T) * random.normal();
    tick.nextLoad_Nm = load;
    ticks.push_back(tick);
  }
  return ticks;
}

}  // namespace breakaway
