// What torque pulses do to a rotor whose friction is compensated more or less.
#pragma once

#include <vector>

#include "base/result.h"
#include "figures/bench_figure.h"
#include "figures/commissioned_bench.h"

namespace breakaway {

struct PulseFigureOptions {
  double step_rad_per_s = 30.0;  ///< what one pulse would do to a rotor without friction
  double mostPulse_s = 0.08;     ///< a heavy rotor gets pulses of this length and makes less of them
  double pulseTorque = 2.5;      ///< a pulse's torque, part of the mean Coulomb friction
  size_t pairs = 4;              ///< of one pulse each way, in a series
  double onePulseSpeed = 0.1;    ///< before the one pulse, part of the highest speed of the velocity sweep
  /// Before the two-way pulses, part of the highest speed of the velocity sweep.
  std::vector<double> speeds = {0.0, 0.1, 0.3, 0.7};
  size_t starts = 8;  ///< around the rotor, from each of which a series from standstill is run
};

/// The response to one pulse: without compensation, with F, with F + B·ω, with the map,
/// beside the rotor without friction, ω₀ + Kt·∫i dt/J. Errors: the course's.
Result<BenchFigure> onePulseFigure(CommissionedBench& bench, const PulseFigureOptions& options = {});

/// Series of pulses there and back, the other way there and back, and so on, one figure per speed, and last their
/// velocity error, the rms distance from the rotor without friction, over the speeds. From standstill the rotor stays
/// within a turn and meets the friction of where it stands: there the error is that of series from all starts, and the
/// figure shows the first.
Result<std::vector<BenchFigure>> twoWayPulseFigures(CommissionedBench& bench, const PulseFigureOptions& options = {});

}  // namespace breakaway
