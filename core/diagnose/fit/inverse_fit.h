// Least squares on the inverse model: drive torque as a linear function of acceleration, velocity, direction and
// effects.
#pragma once

#include <vector>

#include "base/result.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// What was regressed, for those who ask.
struct InverseFit {
  Model model;                 ///< with 95 % intervals, from least squares clustered by stretches of one second
  double relativeError = 0.0;  ///< ‖residual‖/‖drive‖
  size_t rows = 0;
};

/// Fits J, B, F and the linear amplitudes of `model`'s effects; shapes, electrical constants and the torque constant
/// are kept. Rows whose velocity is below its own noise aren't used; creeping ones are, as published inverse fits do.
/// Position is filtered at 100 Hz (a tenth of the sampling rate at most), both sides of the equation alike at 50 Hz (a
/// twentieth at most). Errors: no stretch of motion that is long enough, an effect that can't enter linearly, columns
/// that can't be told apart.
Result<InverseFit> fitInverse(const Model& model, const std::vector<Track>& tracks);

}  // namespace breakaway
