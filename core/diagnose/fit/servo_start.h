// Where a reference drives: the law to start from, and what it makes of the recorded motion.
#pragma once

#include <vector>

#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"
#include "motor/bench.h"

namespace breakaway {

/// What the model's law makes of the motion that a track shows (Track::motion), one entry per row, in units of the
/// input. It errs by what encoder and smoothing hide: good enough to look for what is missing, while fits simulate the
/// law along with the motion.
std::vector<double> reconstructedInput(const Model& model, const Track& track);

/// The bench's law with a delay, if it has none: the one with which the inverse model explains the recordings best; and
/// a gain: the one that goes with the believed inertia, or else 1. Without a damping it has none: the axis' own then
/// holds that of the law as well, which no reference of positions tells apart.
ServoLaw startingLaw(const Bench& bench, const std::vector<Track>& training);

}  // namespace breakaway
