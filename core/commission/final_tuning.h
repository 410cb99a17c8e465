// The controller that commissioning leaves: tuned from the identified motor and its uncertainty.
#pragma once

#include "base/result.h"
#include "commission/commission.h"
#include "experiment/drive.h"

namespace breakaway {

/// Gains and cutoff of medium stiffness (autoTune()) for what `done` has identified, within the board's present limits.
/// The sensor's noise and the encoder's rounding are those that commissioning met; on a linear axis m for rad. Errors:
/// those of autoTune().
Result<ControllerSettings> mediumSettings(const Commission& done, const ControllerSettings& present);

/// The measurements ran with careful gains; the board is left with those that the motor, as it is known now, allows,
/// and the bench file gets them. Where there are none, or the board takes none, it stays as it is and `done` gets a
/// remark.
void tuneForUse(Drive& drive, Commission& done);

/// The settings as a bench file holds them.
BenchController controllerOf(const ControllerSettings& settings);

}  // namespace breakaway
