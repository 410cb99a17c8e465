// Friction maps over a fleet: each one's numbers beside those of its diagnosis, and how the maps lie around the turn.
#pragma once

#include <vector>

#include "draw/svg_plot.h"
#include "fleet/entry.h"
#include "friction/friction_map.h"

namespace breakaway {

/// Adds to the entry's parameters `map_static_friction_Nm` (mean over the bins), `map_position_torque_Nm` (half of its
/// range over the bins), both without an interval, and with theirs `map_coulomb_Nm` and `map_viscous_Nm_s_per_rad`; in
/// N and m on a linear axis. Of a rotor also keeps the map's curves. A map without bins adds nothing.
void addMap(FleetEntry& entry, const FrictionMap& map);

/// Static friction, what keeps it moving, and position torque around the rotor, from the encoder's index: the median of
/// the maps with the middle half of them as a band. Empty with fewer than two maps.
std::vector<Figure> mapFigures(const std::vector<FleetEntry>& entries);

}  // namespace breakaway
