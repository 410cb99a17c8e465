// The controller that commissioning leaves: tuned from the identified motor and its uncertainty.
#pragma once

#include "base/result.h"
#include "experiment/drive.h"
#include "report/commission.h"

namespace breakaway {

/// Gains and cutoff of medium stiffness (autoTune()) for what `done` has identified, within the board's present limits.
/// The sensor's noise and the encoder's rounding are those that commissioning met. Errors: those of autoTune().
Result<ControllerSettings> mediumSettings(const Commission& done, const ControllerSettings& present);

/// The settings as a bench file holds them.
BenchController controllerOf(const ControllerSettings& settings);

}  // namespace breakaway
