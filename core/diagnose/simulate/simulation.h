// Forward simulation of a model along a recording's drive input, with exact stick-slip.
#pragma once

#include <vector>

#include "base/result.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"
#include "recording/recording.h"

namespace breakaway {

/// One value per row of the recording; `current_A` is empty unless voltage or duty drives.
struct Trace {
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> current_A;
  std::vector<size_t> restarts;  ///< rows at which the state was set from measurements
};

struct SimulateOptions {
  double restartEvery_s = 0.0;  ///< 0: only at the first row
};

/// Predicts every row from the recorded drive input alone. Restarts are at the first row with t ≥ t₀ + k·S − 1e-9 s;
/// there the state is set from measurements in rows up to and including that row. Errors: the drive channel or the
/// position is missing.
Result<Trace> simulate(const Model& model, const Recording& recording, const SimulateOptions& options);

/// The same on prepared input. Hidden states carry over from each restart to the next.
Trace simulate(const Model& model, const Track& track, double restartEvery_s);

}  // namespace breakaway
