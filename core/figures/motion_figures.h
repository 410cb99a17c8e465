// Controlled motion with the disturbance observer: a step of the angle, a ramp of the speed.
#pragma once

#include "base/result.h"
#include "figures/bench_figure.h"
#include "figures/commissioned_bench.h"

namespace breakaway {

/// A 180° step of the position controller with disturbance feedback. Key numbers: rise from 10 % to 90 %, overshoot,
/// settling to ±0.5°, and the error at the end. Errors: the course's.
Result<BenchFigure> positionStepFigure(CommissionedBench& bench);

/// From standstill to 100 rpm in 3 s and on for 2 s, the velocity controller with disturbance feedback and without. Key
/// numbers: rms velocity errors on the ramp and after it. Errors: the course's, the drive's.
Result<BenchFigure> velocityRampFigure(CommissionedBench& bench);

}  // namespace breakaway
