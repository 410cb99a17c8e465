// The speed over which friction falls from static to Coulomb.
#pragma once

#include <vector>

#include "base/estimate.h"
#include "experiment/slow_turns.h"
#include "friction/friction_map.h"

namespace breakaway {

/// ω_s of C + (S − C)·exp(−(ω/ω_s)²) + B·|ω| (Armstrong-Hélouvry, "Control of Machines with Friction", 1991) by least
/// squares over slow turns, with the map's means around the rotor for S, C and B, each way its own. The standard error
/// is from the residuals, at least a twentieth of the fall. Value 0 where the turns don't show it: friction that falls
/// by less than 3 %, or fewer than three turns, or none between standing and moving.
Estimate stribeckVelocity(const std::vector<SlowTurn>& turns, const FrictionMap& map, double torqueConstant_Nm_per_A);

}  // namespace breakaway
