// The state at a restart, from measurements in rows up to and including that row.
#pragma once

#include "diagnose/simulate/stepper.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// A moving-horizon observer: the model runs along the last `horizon_s` of drive input; the position and velocity at
/// its begin and a constant load, for what the model lacks, that fit the measured positions best (least squares, two
/// Gauss–Newton steps) give the state at `row`. The load ends there. At the first row the axis is taken to rest.
MotionState restartState(Stepper& stepper, const Track& track, size_t row, double horizon_s);

/// Runs the state from row `from` to row `to` along the track's drive input.
void run(Stepper& stepper, const Track& track, size_t from, size_t to, MotionState& state);

/// Standard deviation of the velocity that restartState() finds, from the track's reading noise alone: the end of a
/// parabola through n readings over `horizon_s` has a slope error of σ·√192/(√n·horizon).
double restartVelocityNoise(const Track& track, double horizon_s);

/// Rows at which windows of `window_s` begin: the first with t ≥ k·window_s − 1e-9 s.
std::vector<size_t> restartRows(const Track& track, double window_s);

}  // namespace breakaway
