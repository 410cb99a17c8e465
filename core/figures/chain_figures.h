// What stands between command and winding, and between winding and number: bridge, current sensor, current loop.
#pragma once

#include "base/result.h"
#include "figures/bench_figure.h"
#include "figures/commissioned_bench.h"

namespace breakaway {

/// The bridge's output duty over its input duty, within a few times the dead zone: by each block of the tests that the
/// motor was identified from, (R·i + Ke·ω)/supply, the curve that commissioning took from them, and an ideal bridge.
/// Key numbers: the dead zone with its standard error, and the blocks' rms distance from the curve and from an ideal
/// bridge. Errors: a commissioning that hasn't kept its tests.
Result<BenchFigure> bridgeFigure(const Commission& measured);

/// What the current sensor reads, before the board takes its zero off, over the winding's current, which the standing
/// rotor's voltages tell through the dead zone and R; the line zero + gain·i with the doubt of the gain, and an ideal
/// sensor. Key numbers: zero, gain with its standard error (1 with the sensor's tolerance unless an inertia is
/// trusted), noise, and how far the readings' means are from the straight line. Errors: as bridgeFigure().
Result<BenchFigure> currentSensorFigure(const Commission& measured);

struct CurrentStepOptions {
  /// The step's levels, parts of the mean Coulomb friction's current: the rotor stands, and the bridge is beyond its
  /// dead zone throughout.
  double from = 0.25, to = 0.75;
  double hold_s = 0.02;  ///< before each step, and after it
  size_t steps = 50;     ///< that are averaged
};

/// The current's step under the board's own current loop, the mean over many while the rotor stands, beside the same
/// loop foretold: the board's controller, tick by tick, around the identified winding behind the measured bridge. Key
/// numbers: times from the step to 63 %, measured and foretold, rms distance between both, overshoot. Errors: the
/// course's, those of loopOfBench().
Result<BenchFigure> currentStepFigure(CommissionedBench& bench, const CurrentStepOptions& options = {});

}  // namespace breakaway
