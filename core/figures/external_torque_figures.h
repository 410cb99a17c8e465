// What a torque from outside does to the rotor, and how well the board sees it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/result.h"
#include "figures/bench_figure.h"
#include "figures/commissioned_bench.h"

namespace breakaway {

/// Torque on the shaft from outside, towards growing angle; times from the board's power-up.
struct ExternalPulse {
  double torque_Nm = 0.0, start_s = 0.0, duration_s = 0.0;
};

/// Opens the commissioned board anew, just powered up, with a pulse to come. Its shaft stands where it stood when the
/// commissioned one was powered up, so that the index is where homing found it.
using OpenPushed = std::function<Result<std::unique_ptr<Drive>>(const ExternalPulse&)>;

struct ExternalTorqueOptions {
  double torque = 2.5;           ///< part of the mean Coulomb friction
  double step_rad_per_s = 30.0;  ///< what the pulse would do to a rotor without friction
  double mostPulse_s = 0.08;
  double speed = 0.1;  ///< before the pulse, part of the highest speed of the velocity sweep
};

/// Three figures. `external-torque`: the pulse itself, and what the board sees of it, the disturbance observer's
/// estimate less the measured friction's torque. `external-torque-response`: the rotor that runs free, its friction
/// compensated by none, F, F + B·ω, and the map, beside a rotor without friction. `external-torque-held`: the velocity
/// controller, with and without disturbance feedback. Key numbers: the rms velocity errors; how near the observed pulse
/// comes. Errors: the drives', the courses'.
Result<std::vector<BenchFigure>> externalTorqueFigures(const CommissionedBench& bench, const OpenPushed& pushed,
                                                       const ExternalTorqueOptions& options = {});

}  // namespace breakaway
