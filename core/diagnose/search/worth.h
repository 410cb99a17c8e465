// What an effect is worth: the error that it takes away from windows that its fit did not see.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "diagnose/search/model_fit.h"

namespace breakaway {

/// Judges fits of a search against one base model.
class Worth {
 public:
  /// `restarts`: mean squared error of the base model's restarts; `floor`: rms error of a perfect model's, rad or
  /// m.
  Worth(const SearchInput& input, const FitResult& base, double restarts, double floor);

  /// Weighted squared error of each training window under the fit that the other folds would give. The last few are
  /// kept: fits are compared with one another again and again.
  std::vector<double> validated(const FitResult& fit) const;
  /// Probability, for the whole catalogue, that chance alone gives such a gain.
  double chance(const std::vector<double>& before, const std::vector<double>& after) const;
  /// Whether the second fit's effects take away error: from windows that a fit did not see or, if they act in few
  /// windows only, at least half of all error.
  bool helps(const FitResult& without, const FitResult& with) const;
  /// Whether what the effect takes away is large enough beside the sensors' noise.
  bool material(const FitResult& without, const FitResult& with) const;
  /// Squared error by which windows have to be worse without an effect that is no more than material, rad² or m²: the
  /// base model has to err by more than sensors explain. `inFew`: nearly all of it lies in a tenth of the windows.
  double leastBack(bool inFew) const;
  /// The same of the current, A²; nothing where none was recorded beside the voltage.
  std::optional<double> leastCurrentBack() const;
  /// Whether the base model errs by hardly more than a perfect one.
  bool baseAtFloor() const;
  /// Whether a recorded current shows much that neither its sensor's noise nor the model explains.
  bool currentErrs(const FitResult& fit) const;
  /// The error of a fit (rms) in units of a perfect model's.
  double floors(const FitResult& fit) const;
  double floor() const { return floor_; }  ///< what a perfect model errs by, rms

 private:
  double currentNoise() const;

  struct Validated {
    std::vector<Parameter> base;
    std::vector<EffectTerm> effects;
    std::vector<double> errors;
  };

  const SearchInput& input_;
  const Criteria& limits_;
  Weights unit_;                           ///< of errors: what the base model leaves
  double base_ = 0.0, baseCurrent_ = 0.0;  ///< its mean square errors
  double restarts_ = 0.0, floor_ = 0.0;
  mutable std::deque<Validated> known_;  ///< the latest first
};

}  // namespace breakaway
