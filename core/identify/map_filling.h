// What a friction map's bins say, once breakaways and moving friction are known: around a rotor as over a travel.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "friction/friction_map.h"
#include "friction/measurements.h"
#include "identify/map_estimation.h"

namespace breakaway {

/// What all breakaways of a way share and turns that repeat don't show: the sensor's zero, what the pooled slope leaves
/// open, and the doubt about the time the rotor takes to show that it moves.
double commonError(const std::vector<BreakawayEvent>& events, Way way, const MapOptions& options);

/// From map.turnStatic_Nm of the way: each bin's mean over turns with its standard error (the scatter between turns,
/// pooled over the bins around, or the mean's finest noise, whichever is larger, the common error, and `scaleError` of
/// the mean), repeatability, outliers, and how many breakaways a bin rests on.
void fillStatic(FrictionMap& map, Way way, const std::vector<BreakawayEvent>& events,
                const std::function<size_t(const BreakawayEvent&)>& binOf, double commonError_Nm,
                double scaleError = 0.0);

/// Coulomb friction in more doubt by waves that the bins don't show, of these mean squares in the breakaways of both
/// ways. What moves need not have them in the same phases, nor one way as large as the other: the larger counts.
void widenCoulomb(std::array<MovingFriction, 2>& moving, const std::array<double, 2>& finer_Nm2);

/// Coulomb, viscous and total of each bin, and both averages.
void fillMoving(FrictionMap& map, const std::array<MovingFriction, 2>& moving);

}  // namespace breakaway
