// What else shows that an extended model is right: the gain reached, what the errors still have in common, the worst
// place.
#pragma once

#include <vector>

#include "diagnose/diagnosis.h"
#include "diagnose/fit/window.h"

namespace breakaway {

/// `before` and `after` are mean squares per held-out window; `fit` knows the floor.
Proof proofOf(const Model& best, const std::vector<Track>& tracks, const std::vector<Window>& heldout,
              const std::vector<double>& before, const std::vector<double>& after, const FitScore& fit);

/// Whether a series is white: its autocorrelation at one step, and the p-value of G. M. Ljung, G. E. P. Box, 'On a
/// measure of lack of fit in time series models', Biometrika 65(2), 1978. NaN values are gaps. 1 where there are fewer
/// than eight values.
struct Whiteness {
  double lag1 = 0.0;
  double pValue = 1.0;
};
Whiteness whitenessOf(const std::vector<double>& series);

}  // namespace breakaway
