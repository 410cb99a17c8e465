// What else shows that an extended model is right: the gain reached, what the errors still have in common, the worst
// place.
#pragma once

#include <string>
#include <vector>

#include "diagnose/fit/window.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"
#include "diagnose/verdict/fit_score.h"

namespace breakaway {

/// A held-out window.
struct Block {
  std::string recording;
  double start_s = 0.0;              ///< on the recording's clock
  size_t track = 0;                  ///< among the training recordings, then the held-out ones
  double before = 0.0, after = 0.0;  ///< RMSE
};

/// What else the held-out data says.
struct Proof {
  double achieved = 0.0;         ///< (before² − after²)/(before² − floor²)
  double lag1 = 0.0;             ///< autocorrelation, from window to window, of what each window ends with
  double whitenessPValue = 1.0;  ///< that a complete model shows as much of it
  Block worst, typical;          ///< by the error after
};

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
