// How a linear axis' sweeps are laid out, from what is known of the axis.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "commission/known.h"
#include "experiment/travel.h"
#include "experiment/travel_bins.h"
#include "experiment/travel_breakaway.h"
#include "experiment/travel_homing.h"
#include "experiment/travel_sweep.h"
#include "identify/travel_friction.h"

namespace breakaway {

/// Counted from elsewhere.
Travel moved(const Travel& travel, double by_m);
/// Whether both ends were felt at the same places again, within 1 % of the travel.
bool sameEnds(const Travel& before, const Travel& now);

// Positions as the encoder counts them; `axis`: with its motor, its ends and, where something is laid over the travel,
// its index and its pace.

/// Of one count.
double count_m(const Commission& axis);
/// So that the axis speeds up with about what friction takes, over less than a third of the travel.
TravelPace paceOf(const Commission& axis);
/// The index where there is none: the lower end.
Estimate lowerEnd(const Commission& axis);
TravelHomingOptions homingOver(const Commission& axis);
/// The bins of both sweeps.
TravelBins binsOver(const Commission& axis);
/// The speeds are these parts of the pace's, or of a lower one that was asked for, in this order, but not so slow that
/// a stroke would take much longer than a run.
TravelSweepOptions velocitySweepOver(const Commission& axis, std::span<const double> parts);
/// `moving_A` as of movingCurrent_A().
TravelBreakawayOptions breakawaySweepOver(const Commission& axis, const std::array<std::vector<double>, 2>& moving_A);
TravelFrictionOptions frictionOver(const Commission& axis);

}  // namespace breakaway
