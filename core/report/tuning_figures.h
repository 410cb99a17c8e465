// Pictures of a tuned loop.
#pragma once

#include "draw/svg_plot.h"
#include "stability/tuning_study.h"

namespace breakaway {

/// Poles over the cutoff in the z plane with the unit circle, the line of ζ = 0.707 and the poles at the loop's own
/// cutoff.
Figure rootLocusFigure(const ServoLoop& loop, const RootLocus& locus);
/// The same as s = ln(z)/T in rad/s, near the origin: how fast and how damped what one sees at the shaft is. Arrows
/// point to where the poles go as g grows.
Figure slowPolesFigure(const ServoLoop& loop, const RootLocus& locus);
Figure gainFigure(const TuningStudy& study);
Figure phaseFigure(const TuningStudy& study);
Figure sensitivityFigure(const TuningStudy& study);
/// The shaft's speed per load torque, of both loops.
Figure loadFigure(const TuningStudy& study);
Figure noiseFigure(const TuningStudy& study);
/// Noise and yielding over the speed observer's bandwidth, each per what the chosen one has.
Figure speedObserverFigure(const InnerLoops& inner, bool linear);
/// Noise that the current sensor makes in the winding over the current loop's bandwidth. Precondition: a winding.
Figure currentLoopFigure(const InnerLoops& inner);

}  // namespace breakaway
