// What an encoder that sits off its centre does to runs at constant speed.
#pragma once

#include <array>

#include "identify/friction_line.h"

namespace breakaway {

/// A speed that an eccentric encoder (by e rad) shows as constant swings once per turn, and the rotor's inertia with
/// it: J·e·ω², one and the same wave on the shaft whichever way it turns, where friction grows with ω at most. Fits
/// that wave E beside each way's C + B·|ω| at order 1, and takes it off the runs where it clearly shows (a gain in χ²
/// of 20 for its two numbers); its doubt goes to their variance. Needs three speeds each way; does nothing else.
void takeOffEncoderSwing(std::array<WayRuns, 2>& ways);

}  // namespace breakaway
