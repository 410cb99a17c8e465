// What an effect would take away as simulated windows see it: for where the regression on the linear rig is misled.
#pragma once

#include <vector>

#include "diagnose/search/model_fit.h"

namespace breakaway {

/// An effect's best shape by the slopes of a fit's windows: how the residuals would change with a little of it, beside
/// all that the fit may change itself.
struct SlopePick {
  Pick pick;          ///< without parameters if slopes don't tell, or if they give an implausible size
  double part = 0.0;  ///< of the fit's squared residuals that it takes away, if all were linear
};

/// Slopes don't tell of effects with hidden states, waves of many orders (which the regression finds), effects that act
/// at standstill, elastic friction or changed inputs, nor of any effect if the model has hidden states. An effect that
/// happens once is looked for in all windows alike, however much they err.
SlopePick slopePick(const SearchInput& input, const FitResult& fit, const Effect& effect);

}  // namespace breakaway
