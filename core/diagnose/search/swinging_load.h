// Loads behind a spring or a gap, which a regression hardly shows: their shapes by simulation.
#pragma once

#include "diagnose/search/model_fit.h"

namespace breakaway {

/// Whether the effect brings a load along that has a motion of its own.
bool swings(const Pick& pick);
bool swings(const Model& model);

/// A shape, and how much it leaves of the squared error of the windows looked at.
struct Shaped {
  Pick pick;
  double left = 1.0;
};

/// The shape that does best in a few simulated windows beside `model`: of the pick's own and those on offer, and then a
/// step at a time from it. A pick that doesn't swing stays as it is.
Shaped simulatedShape(const SearchInput& input, const Model& model, Pick pick);

}  // namespace breakaway
