// What belongs to something else than the motion that was taken.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Where columns are called by devices and a stroke ("Arm/Position", "Claw/Position"), those of devices that nothing
/// drives are set aside if another one moves and is driven.
void preferDriven(const RawTable& table, std::vector<Choice>& choices);

/// Once one column is chosen for each thing: sets aside what another angle shall be ("handle_angle_cmd").
void setUnmovedReferencesAside(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
