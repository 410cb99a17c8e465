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
  /// The same fits on `input`, which has some of the windows, and the base's squares in them. What helps is still
  /// judged by all windows.
  SetFits(const SetFits& other, const SearchInput& input, const FitResult& base);

  /// Finds loadsMayShow(). `left`: what the base model leaves, taken for a torque that wanders.
  void weighRestarts(const TorqueNoise& left);
  const Worth& worth() const { return worth_; }
  /// Whether restarts of the base model err by more than sensors and scattering friction explain: only then can a load
  /// that swings or flies be there.
  bool loadsMayShow() const { return loadsMayShow_; }
  /// Loads are tried from now on, because the screen has found one. Without loadsMayShow() it has to leave far less of
  /// the restarts' error.
  void expectLoads() { expected_ = true; }
  bool loadsAreTried() const { return loadsMayShow_ || expected_; }
  /// Whether the second model takes away error. At each window's start the place of a load that swings is fitted, which
  /// follows noise, too. So a load has to do clearly better after restarts as well, where its place isn't fitted.
  bool helps(const FitResult& without, const FitResult& with) const;
  /// The same for friction that grows at rest, by the windows as fitted: a linearised fold can't foretell when an axis
  /// breaks away.
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
  const Criteria& limits_;
  const FitResult& base_;
  double restarts_;  ///< mean squared error of the base model's
  Worth worth_;
  bool loadsMayShow_ = false, expected_ = false;
};

}  // namespace breakaway
