// What torque pulses do to a rotor whose friction is compensated more or less.
#pragma once

#include <vector>

#include "base/result.h"
#include "figures/bench_figure.h"
#include "figures/commissioned_bench.h"

namespace breakaway {

struct PulseFigureOptions {
  double step_rad_per_s = 30.0;                  ///< what one pulse would do to a rotor without friction
  double mostPulse_s = 0.08;                     ///< a heavy rotor gets pulses of this length and makes less of them
  double pulseTorque = 2.5;                      ///< a pulse's torque, part of the mean Coulomb friction
  size_t pairs = 3;                              ///< of one pulse each way, in a series
  std::vector<double> speeds = {0.1, 0.3, 0.7};  ///< before the pulses, part of the highest speed of the velocity sweep
};

/// The response to one pulse from the lowest of the speeds: without compensation, with F, with F + B·ω, with the map,
/// beside the rotor without friction, ω₀ + Kt·∫i dt/J. Errors: the course's.
Result<BenchFigure> onePulseFigure(CommissionedBench& bench, const PulseFigureOptions& options = {});

/// Series of two-way pulses, one figure per speed, and last their velocity error, the rms distance from the rotor
/// without friction, over the speeds.
Result<std::vector<BenchFigure>> twoWayPulseFigures(CommissionedBench& bench, const PulseFigureOptions& options = {});

}  // namespace breakaway
