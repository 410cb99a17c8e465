// Tuning of the connected board from what is known of its motor, without a window.
#pragma once

#include <QString>
#include <optional>

#include "commission/known.h"
#include "experiment/drive.h"
#include "motor/bench.h"
#include "stability/auto_tuning.h"

namespace breakaway {

/// The motor as well as it is known.
struct KnownMotor {
  LoopMotor values;  ///< resistance or inductance 0: unknown
  Estimate inertia_kg_m2, torqueConstant_Nm_per_A;
  double currentNoise_A = 0.018;  ///< of the board's sensor
  QString source;                 ///< "identified", "bench file" or "name plate"
};

/// From the identification with its intervals, per ampere as the sensor shows it; else from the bench file, within ±5 %
/// (inertia) and ±2.7 % (torque constant); else from the nominal values that are set, within ±30 %.
KnownMotor knownMotor(const ControllerSettings& settings, const std::optional<Bench>& bench, const Commission& known);

/// The velocity loop that the board closes with these settings around that motor. A simulated board answers within the
/// tick, any other from the next.
ServoLoop boardLoop(const Identity& identity, const ControllerSettings& settings, const KnownMotor& motor);

/// The settings with gains, cutoff and nominal values tuned; limits and integrals as they are, ki and kd 0. Errors:
/// those of autoTune().
Result<ControllerSettings> tunedSettings(const Identity& identity, const ControllerSettings& settings,
                                         const KnownMotor& motor, Stiffness stiffness);

}  // namespace breakaway
