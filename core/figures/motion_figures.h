// Controlled motion with the disturbance observer: a step of the angle, a ramp of the speed.
#pragma once

#include <vector>

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

/// One speed of the constant-velocity test over time, from standstill: the speed as the board's observer has it, and
/// the torque, Kt·i beside the disturbance observer's estimate; the whole turns that are averaged are marked. Key
/// numbers: the averages over them, and what the velocity sweep's line says at that speed. Errors: the course's; fewer
/// than one turn.
Result<std::vector<BenchFigure>> constantVelocityOverTimeFigures(CommissionedBench& bench);

/// Methods A and B of friction compensation on the samples of one motion, a sine of speed through standstill: the
/// friction model F·sgn ω + B·ω that goes into both, what each makes of it with the tuned cutoff, and their difference,
/// in double and in single precision. Key numbers: the rms differences, their part of the torque. Errors: the course's.
Result<BenchFigure> methodsFigure(CommissionedBench& bench);

}  // namespace breakaway
