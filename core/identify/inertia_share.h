// What an inertia that is off does to runs at constant speed, where an arm or cogging makes the rotor speed up and slow
// down.
#pragma once

#include <array>

#include "identify/friction_line.h"

namespace breakaway {

/// Kt·i_k − J·a_k is off by ΔJ·a_k in all runs alike, and what grows with the speed there passes for viscous friction.
/// Fits one ΔJ beside each order's and way's C + B·|ω| (and at order 1 an eccentric encoder's wave, encoder_swing.h),
/// from the orders and runs whose acceleration stands far out of its noise, with what is known of J beforehand: ΔJ = 0
/// within `inertiaError_kg_m2`. Takes ΔJ·a_k off the runs; what is left of the doubt goes to their variance.
void freeOfInertia(std::array<WayRuns, 2>& ways, double inertia_kg_m2, double inertiaError_kg_m2);

}  // namespace breakaway
