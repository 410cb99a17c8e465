#include "figures/observer_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/statistics.h"
#include "observer/disturbance_observer.h"
#include "observer/edge_timed_velocity.h"
#include "observer/kalman_velocity.h"
#include "observer/velocity_observer.h"

namespace breakaway {

namespace {

constexpr double settled = 0.1;  // part of a run that is left to the observers to settle
constexpr double edgeWindow_s = 1e-3;

using Velocities = std::vector<double>;

KalmanVelocity<double> kalmanFor(const ObservedRotorOptions& rotor) {
  KalmanVelocity<double> kalman;
  kalman.configure({rotor.inertia_kg_m2, rotor.torqueConstant_Nm_per_A, rotor.count_rad, rotor.loadWalk_Nm_per_sqrt_s,
                    rotor.currentNoise_A},
                   rotor.tick_s);
  return kalman;
}

Velocities backwardDifference(const std::vector<ObservedTick>& ticks, const ObservedRotorOptions& rotor) {
  Velocities velocity;
  double last = ticks.front().angle_rad;
  for (const ObservedTick& tick : ticks) {
    velocity.push_back((tick.angle_rad - last) / rotor.tick_s);
    last = tick.angle_rad;
  }
  return velocity;
}

Velocities edgeTimed(const std::vector<ObservedTick>& ticks, const ObservedRotorOptions& rotor) {
  EdgeTimedVelocity<double> timed;
  timed.configure(rotor.count_rad, edgeWindow_s);
  Velocities velocity;
  for (const ObservedTick& tick : ticks) velocity.push_back(timed.step(tick.edge_rad, tick.sinceEdge_s, rotor.tick_s));
  return velocity;
}

Velocities luenberger(const std::vector<ObservedTick>& ticks, const ObservedRotorOptions& rotor, double bandwidth) {
  VelocityObserver<double> observer;
  observer.configure(bandwidth, rotor.torqueConstant_Nm_per_A / rotor.inertia_kg_m2, rotor.tick_s);
  observer.reset(ticks.front().angle_rad);
  Velocities velocity;
  for (const ObservedTick& tick : ticks) velocity.push_back(observer.step(tick.angle_rad, tick.current_A));
  return velocity;
}

struct KalmanRun {
  Velocities velocity, load;
};

KalmanRun kalman(const std::vector<ObservedTick>& ticks, const ObservedRotorOptions& rotor) {
  KalmanVelocity<double> filter = kalmanFor(rotor);
  filter.reset(ticks.front().angle_rad);
  KalmanRun run;
  for (const ObservedTick& tick : ticks) {
    run.velocity.push_back(filter.step(tick.angle_rad, tick.current_A));
    run.load.push_back(filter.load_Nm());
  }
  return run;
}

double velocityError(const std::vector<ObservedTick>& ticks, const Velocities& velocity) {
  Velocities error;
  for (auto k = static_cast<size_t>(settled * static_cast<double>(ticks.size())); k < ticks.size(); ++k)
    error.push_back(velocity[k] - ticks[k].velocity_rad_per_s);
  return rms(error);
}

double loadError(const std::vector<ObservedTick>& ticks, const std::vector<double>& load_Nm) {
  std::vector<double> error;
  for (auto k = static_cast<size_t>(settled * static_cast<double>(ticks.size())); k < ticks.size(); ++k)
    error.push_back(load_Nm[k] - ticks[k].nextLoad_Nm);
  return rms(error);
}

std::vector<double> disturbances(const std::vector<ObservedTick>& ticks, const ObservedRotorOptions& rotor,
                                 double cutoff, const Velocities& velocity) {
  DisturbanceObserver<double> observer;
  observer.configure({cutoff, rotor.inertia_kg_m2, rotor.torqueConstant_Nm_per_A}, rotor.tick_s);
  observer.reset(velocity.front());
  std::vector<double> load_Nm;
  load_Nm.reserve(ticks.size());
  for (size_t k = 0; k < ticks.size(); ++k) load_Nm.push_back(observer.step(ticks[k].current_A, velocity[k]));
  return load_Nm;
}

struct Estimator {
  const char* column;
  const char* label;
};
constexpr std::array<Estimator, 4> estimators{{{"backward_difference", "backward difference"},
                                               {"edge_timed", "edge-timed (M/T)"},
                                               {"luenberger", "Luenberger"},
                                               {"kalman", "Kalman"}}};
constexpr std::array<Estimator, 4> feeds{{{"backward_difference", "fed by backward difference"},
                                          {"luenberger", "by Luenberger, fixed bandwidth"},
                                          {"luenberger_3g", "by Luenberger at 3g"},
                                          {"kalman_speed", "by Kalman"}}};

}  // namespace

BenchFigure velocityEstimatorFigure(const ObserverFigureOptions& options) {
  BenchFigure figure{"velocity-estimators",
                     "Rms error of the speed, swinging by a third around its mean under a wandering load, against the "
                     "truth. Edge-timed velocity needs a capture timer; it is best where edges are rare.",
                     {"Velocity estimators", "mean speed / rad/s", "error, rms / rad/s"},
                     {{"speed_rad_per_s", options.speeds_rad_per_s}}};
  figure.figure.logX = figure.figure.logY = true;
  for (const Estimator& one : estimators) figure.columns.push_back({std::string(one.column) + "_rad_per_s", {}});
  for (const double speed : options.speeds_rad_per_s) {
    ObservedRotorOptions rotor = options.rotor;
    rotor.speed_rad_per_s = speed;
    rotor.swing_rad_per_s = speed / 3.0;
    const auto ticks = observeRotor(rotor);
    const Velocities all[] = {backwardDifference(ticks, rotor), edgeTimed(ticks, rotor),
                              luenberger(ticks, rotor, options.velocityBandwidth_rad_per_s),
                              kalman(ticks, rotor).velocity};
    for (size_t k = 0; k < estimators.size(); ++k) figure.columns[k + 1].values.push_back(velocityError(ticks, all[k]));
  }
  for (size_t k = 0; k < estimators.size(); ++k) {
    const std::string column = figure.columns[k + 1].name;
    figure.figure.curves.push_back(drawn(figure, estimators[k].label, "speed_rad_per_s", column));
    figure.keyNumbers.emplace_back("mean_" + column, mean(figure.columns[k + 1].values));
  }
  return figure;
}

BenchFigure disturbanceCutoffFigure(const ObserverFigureOptions& options) {
  const ObservedRotorOptions& rotor = options.rotor;
  const auto ticks = observeRotor(rotor);
  const KalmanRun best = kalman(ticks, rotor);
  const double kalmanError = loadError(ticks, best.load);
  BenchFigure figure{"disturbance-cutoff",
                     "The disturbance observer's torque against the true load of a simulated rotor, one tick late, "
                     "over the cutoff, fed with four kinds of speed; the dashed line is the Kalman filter for these "
                     "sensors and this load.",
                     {"Torque error over the cutoff", "cutoff g / rad/s", "torque error, rms / mNm"},
                     {{"cutoff_rad_per_s", {}}}};
  for (const Estimator& one : feeds) figure.columns.push_back({std::string(one.column) + "_Nm", {}});
  figure.columns.push_back({"kalman_Nm", {}});
  const Velocities raw = backwardDifference(ticks, rotor);
  const Velocities fixed = luenberger(ticks, rotor, options.velocityBandwidth_rad_per_s);
  for (size_t k = 0; k < options.cutoffs; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(std::max<size_t>(2, options.cutoffs) - 1);
    const double g = options.lowestCutoff_rad_per_s *
                     std::pow(options.highestCutoff_rad_per_s / options.lowestCutoff_rad_per_s, part);
    const Velocities matched = luenberger(ticks, rotor, 3.0 * g);
    const Velocities* const speeds[] = {&raw, &fixed, &matched, &best.velocity};
    figure.columns[0].values.push_back(g);
    for (size_t j = 0; j < feeds.size(); ++j)
      figure.columns[j + 1].values.push_back(loadError(ticks, disturbances(ticks, rotor, g, *speeds[j])));
    figure.columns.back().values.push_back(kalmanError);
  }
  figure.figure.logX = figure.figure.logY = true;
  for (size_t j = 0; j < feeds.size(); ++j) {
    const auto& error = figure.columns[j + 1].values;
    const auto least = std::min_element(error.begin(), error.end());
    const std::string name = feeds[j].column;
    figure.figure.curves.push_back(drawn(figure, feeds[j].label, "cutoff_rad_per_s", name + "_Nm", 1e3));
    figure.keyNumbers.emplace_back("best_cutoff_" + name + "_rad_per_s",
                                   figure.columns[0].values[static_cast<size_t>(least - error.begin())]);
    figure.keyNumbers.emplace_back("best_" + name + "_over_kalman", *least / kalmanError);
  }
  figure.figure.curves.push_back(drawn(figure, "Kalman filter", "cutoff_rad_per_s", "kalman_Nm", 1e3));
  figure.figure.curves.back().style = Curve::Style::dashed;
  figure.figure.curves.back().colour = 6;
  figure.keyNumbers.emplace_back("kalman_error_Nm", kalmanError);
  return figure;
}

}  // namespace breakaway
