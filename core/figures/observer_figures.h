// How well observers see speed and load, against the truth of a rotor whose sensors are known.
#pragma once

#include <vector>

#include "figures/bench_figure.h"
#include "figures/observed_rotor.h"

namespace breakaway {

struct ObserverFigureOptions {
  ObservedRotorOptions rotor;
  double velocityBandwidth_rad_per_s = 400.0;  ///< of the Luenberger observer that keeps its bandwidth
  std::vector<double> speeds_rad_per_s = {0.5, 1.5, 5.0, 15.0, 50.0};
  size_t cutoffs = 21;
  double lowestCutoff_rad_per_s = 20.0;
  double highestCutoff_rad_per_s = 2000.0;
};

/// Rms error of the speed over several mean speeds that swing by a third: backward difference, edge-timed (M/T),
/// Luenberger and Kalman. Columns and key numbers in rad/s.
BenchFigure velocityEstimatorFigure(const ObserverFigureOptions& options);

/// Rms error of the disturbance observer's torque over its cutoff, one tick late, when it is fed with the speed of the
/// backward difference, of the Luenberger observer at a fixed bandwidth and at three times the cutoff, and of the
/// Kalman filter; beside it the stationary Kalman filter's own load. Key numbers: each one's best, and as part of the
/// Kalman filter's.
///
/// Why three times the cutoff: behind a speed whose observer has the poles (s+w)³, the torque follows the load by
/// g/(s+g)·(3w²s + w³)/(s+w)³, and at g = w/3 the observer's pole cancels that zero: w³/(s+w)³ is left. Behind a Kalman
/// filter with poles s³+2ω₀s²+2ω₀²s+ω₀³, what it has without current noise, the zero lies at ω₀/2: fed with that speed
/// and at that cutoff the disturbance observer is the Kalman filter.
BenchFigure disturbanceCutoffFigure(const ObserverFigureOptions& options);

}  // namespace breakaway
