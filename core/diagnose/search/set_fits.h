// Sets of effects as the screen proposes them, fitted by simulation, and whether they help.
#pragma once

#include <vector>

#include "diagnose/search/model_fit.h"
#include "diagnose/search/worth.h"

namespace breakaway {

/// Fits on top of one base model. Keeps references to what it is made from.
class SetFits {
 public:
  SetFits(const SearchInput& input, const FitResult& base);

  /// Looks whether loads may show. `left`: what the base model leaves, taken for a torque that wanders.
  void weighRestarts(const TorqueNoise& left);
  const Worth& worth() const { return worth_; }
  /// Whether restarts of the base model err by more than sensors and friction that scatters may do: a load that swings
  /// or flies leaves much.
  bool loadsMayShow() const { return loadsMayShow_; }
  /// From now on they may, since the screen has found one: it has to leave far less of restarts, then.
  void expectLoads() { expected_ = true; }
  bool loadsAreTried() const { return loadsMayShow_ || expected_; }
  /// Whether the second model takes away error. A load that swings is free at each window's start, which noise can use,
  /// too: it has to do clearly better from restarts as well, where it isn't.
  bool helps(const FitResult& without, const FitResult& with) const;
  /// The same by the windows as fitted, for friction that grows at rest: when an axis breaks away no linearised fold
  /// foretells.
  bool breaksAwayBetter(const FitResult& without, const FitResult& with) const;
  /// Whether a model leaves clearly less of another's error when the training windows restart.
  bool clearlyBetterFromRestarts(const FitResult& fit, const FitResult& other) const;

  /// A short fit, from a start that is near.
  FitResult fresh(const Model& start) const;
  /// The set in the base model's place, from the screen's sizes, or from others where that doesn't lead far.
  FitResult together(const Screen& screen, const std::vector<Pick>& picks) const;
  /// The last of the picks on top of a model that has the others and leaves the squared error `left`.
  FitResult beside(const Model& model, const Screen& screen, const std::vector<Pick>& picks, double left) const;

 private:
  const SearchInput& input_;
  const FitResult& base_;
  double restarts_;  ///< mean squared error of the base model's
  Worth worth_;
  bool loadsMayShow_ = false, expected_ = false;
};

}  // namespace breakaway
