// The controller that measurements run with.
#pragma once

#include "experiment/drive.h"

namespace breakaway {

/// The present settings with gains and cutoff that are careful enough for every measurement. `inertia` in kg m² or kg,
/// `perAmpere` in Nm/A or N/A.
ControllerSettings carefullyTuned(double inertia, double perAmpere, double tick_s, const ControllerSettings& present);

}  // namespace breakaway
