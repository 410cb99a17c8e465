// The simulated board as a drive: control loop against a plant, with the whole sensor chain between them.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "experiment/drive.h"

namespace breakaway {

/// Opens the board at `uri`: `simulated`, `simulated:PRESET` or `simulated:FILE.rig.json` (resources/help/files.md).
/// `seed` drives noise and scatter. Presets are looked for beside the program and in the source tree's resources. The
/// board starts off, its settings tuned from the motor's name plate, which gives torque constant and inertia to one
/// significant digit.
Result<std::unique_ptr<Drive>> openDrive(const std::string& uri, unsigned seed);

}  // namespace breakaway
