// A rig file's numbers as the emulated board's image carries them. On the host, when the image is built.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "firmware_link/board/cortex_m3/emulated_rig.h"
#include "plant/rig.h"

namespace breakaway {

/// Owns the cells that its rig points to; not to be copied.
struct RigTables {
  EmulatedRig rig{};
  std::vector<EmulatedCell> cells;

  RigTables() = default;
  RigTables(const RigTables&) = delete;
  RigTables& operator=(const RigTables&) = delete;
  RigTables(RigTables&&) = default;
  RigTables& operator=(RigTables&&) = default;
};

/// Tabulates the same functions that the truth is computed from (plant/physics.h). Errors: an effect that isn't a
/// function of the angle alone, a fault, an encoder without whole counts: the emulated plant has none of these.
Result<RigTables> rigTables(const Rig& rig);

/// The text of a header that defines `breakaway::emulatedRig`, and `emulatedHardware`: the board that is made for it,
/// as hardwareOf() gives it.
std::string rigHeader(const RigTables& tables, const Rig& rig);

}  // namespace breakaway
