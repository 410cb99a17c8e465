// Friction of the commissioned rotor: at constant speed, and around the turn.
#pragma once

#include <vector>

#include "commission/known.h"
#include "figures/bench_figure.h"

namespace breakaway {

/// The motor torque that keeps each speed of the velocity sweep, and the line F + B·|ω| of each way. Key numbers: F and
/// B each way with their standard errors.
BenchFigure constantVelocityFigure(const Commission& measured);

/// Breakaway torque around the rotor turn by turn, one figure per way (cw, ccw). Key numbers: the mean, and how well
/// consecutive turns repeat.
std::vector<BenchFigure> staticFrictionFigures(const Commission& measured);

/// Breakaway torque around the rotor, both ways, with the 95 % interval of each bin as a band, polar. Key numbers: the
/// means, the mean half width of the intervals, and how much the torque varies around the rotor.
BenchFigure breakawayMapFigure(const Commission& measured);

/// The viscous coefficient around the rotor: raw, the slope over the speeds of each bin's own mean torque
/// Kt·i − J·½·dω²/dθ, and filtered to the harmonics that stand out of the noise. One figure per way.
std::vector<BenchFigure> viscousFigures(const Commission& measured);

/// Viscous torque around the rotor, B(θ)·ω, at the map's total velocity, both ways.
BenchFigure totalViscousFigure(const Commission& measured);

/// Coulomb and viscous torque together at the map's total velocity, both ways: all that friction and position torque
/// ask of the motor.
BenchFigure overallFrictionFigure(const Commission& measured);

}  // namespace breakaway
