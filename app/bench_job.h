// The bench's measurements as runs for the I/O thread: what each needs, in which order, and what it leaves behind.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "experiment/breakaway_sweep.h"
#include "experiment/velocity_sweep.h"
#include "identify/motor_identification.h"
#include "run.h"

namespace breakaway {

struct BreakawayRequest {
  size_t bins = 180;
  size_t turns = 2;
  double index_rad = 0.0;
  double indexTolerance_rad = 0.0;  ///< 0: the index is not watched
  std::optional<double> trustedTorqueConstant_Nm_per_A;
  std::optional<Identification> identification;  ///< without one the motor is identified first
  std::vector<VelocityRun> runs;        ///< earlier runs at constant speed, if any: they tell what keeps it moving
  std::vector<BreakawayEvent> earlier;  ///< of an interrupted sweep, not measured again
  double countsPerRev = 0.0;
  double current_limit_A = 0.0;
};

struct VelocityRequest {
  VelocitySweepOptions options;
  std::vector<VelocityRun> earlier;              ///< of an interrupted sweep, not run again
  std::optional<Identification> identification;  ///< without one the motor is identified first
  std::optional<double> trustedTorqueConstant_Nm_per_A;
};

/// Current sensor's zero, winding test, spin test: about a minute of motion both ways.
Run identificationRun(std::optional<double> trustedTorqueConstant_Nm_per_A);
/// The breakaway sweep, after the identification where there is none.
Run breakawayRun(const BreakawayRequest& request);
/// The velocity sweep, after the identification where there is none.
Run velocitySweepRun(const VelocityRequest& request);

}  // namespace breakaway
