// Whether a trial's data can tell what it conceals: decided from the truth, not from any answer.
#pragma once

#include "base/result.h"
#include "trial/sealed_trial.h"

namespace breakaway {

/// Errors are RMSE on held-out windows, rad or m.
struct Identifiability {
  double base = 0.0;       ///< of the base model, fitted
  double floor = 0.0;      ///< of a perfect model
  double truth = 0.0;      ///< of the base model with the concealed effects, fitted; 0 for clean and outside
  bool material = false;   ///< the base model errs at least 1.6 times the floor
  bool separable = false;  ///< the best refitted rival is worse than the truth by two standard errors; true for outside

  bool identifiable() const { return material && separable; }
};

/// Rivals have one concealed effect replaced by one that looks alike, at most three in all; where nothing looks alike,
/// left out. Errors: what diagnose() refuses, a concealed effect that the catalogue lacks or whose fit fails.
Result<Identifiability> identifiability(const SealedTrial& trial);

}  // namespace breakaway
