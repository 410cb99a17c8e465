// Which effects a recording asks for, by linear regression over the whole catalogue at once: fast, before any
// simulation decides.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <vector>

#include "diagnose/model/criteria.h"
#include "diagnose/screen/column_memo.h"
#include "diagnose/screen/linear_rig.h"

namespace breakaway {

/// One effect as the screen found it.
struct Pick {
  const Effect* effect = nullptr;
  Shape shape;
  size_t track = everyTrack;          ///< the one track that it happens in
  std::vector<double> parameters;     ///< at its amplitude
  double gain = 0.0;                  ///< squared residual that it takes away, on top of the others
  double pValue = 1.0;                ///< family-wise
  std::vector<const Effect*> rivals;  ///< that do as well in its place, within two standard errors, best first
};

/// Whether the two are one effect, or twins that no recording tells apart.
bool same(const Effect* a, const Effect* b);

/// Whether an effect, or its twin, is among the picks.
bool contains(const std::vector<Pick>& picks, const Effect* effect);

/// The largest gain first.
void sortByGain(std::vector<Pick>& picks);

struct ScreenResult {
  std::vector<Pick> chosen;  ///< most important first
  double baseSquares = 0.0;  ///< what the base model leaves, in squared typical residuals
  double leftSquares = 0.0;  ///< what base and chosen leave
};

/// Forward selection from several first choices (a beam), each nonlinear parameter refined before the next step;
/// exchange of each choice for every other effect; backward elimination. A term stays when it takes away more than
/// chance could anywhere in the catalogue (sign flips of whole windows of what is left after it: wild bootstrap,
/// maximum over all candidates) and when held-out folds agree, unless it lives in a few windows only. Effects are
/// compared by cross-validated error.
class Screen {
 public:
  /// `fold` is the window's fold, 0 … folds − 1.
  Screen(const LinearRig& rig, const std::vector<const Effect*>& effects, const Excitation& seen,
         const std::vector<int>& fold, int folds, std::uint64_t seed, const Criteria& criteria);

  ScreenResult run() const;
  const std::vector<const Effect*>& effects() const { return effects_; }
  /// The effect's best shape and amplitude on top of the base and `others`; no parameters where it can't help.
  Pick best(const Effect& effect, const std::vector<Pick>& others) const;
  /// The base's physics, fitted together with `chosen`: J, B with the back-EMF's share, F …
  Eigen::VectorXd baseCoefficients(const std::vector<Pick>& chosen) const;

 private:
  struct Candidate {
    const Effect* effect;
    Shape shape;
    size_t track;
    Eigen::Index at, width;  ///< columns
  };
  /// Base and chosen columns, orthonormal, and what they leave of the response and of all candidates.
  struct Left {
    Eigen::MatrixXd basis;
    Eigen::VectorXd response;
    Eigen::MatrixXd shared;  ///< parts of the candidates' free columns along the chosen part of the basis
    Eigen::VectorXd scores;  ///< products of the candidates' columns and the response
  };
  Left leave(const std::vector<Pick>& chosen) const;
  Left leaveOnlyResponse(const std::vector<Pick>& chosen) const;  ///< without the candidates' part
  /// Products of a candidate's columns among themselves, as far as base and chosen leave them.
  Eigen::MatrixXd gramOf(const Candidate& candidate, const Left& left) const;
  static Eigen::MatrixXd orthonormal(Eigen::MatrixXd columns);
  Pick bestOf(const Effect* effect, const Left& left) const;  ///< null: of all effects, refined
  std::vector<Pick> bestOfEach(const Left& left, const std::vector<Pick>& chosen) const;
  Pick refined(Pick pick, const Left& left) const;
  double gainOf(const Eigen::MatrixXd& columns, const Left& left, Eigen::VectorXd& amplitude) const;
  double pValueOf(const Pick& pick, const Left& before, double& chance) const;
  std::vector<Pick> grow(std::vector<Pick> chosen) const;
  std::vector<Pick> exchange(std::vector<Pick> chosen) const;
  std::vector<Pick> prune(std::vector<Pick> chosen) const;
  /// Squared residual per window, each fold predicted from the others.
  std::vector<double> validated(const std::vector<Pick>& chosen) const;
  const Eigen::MatrixXd& columnsOf(const Pick& pick) const;
  Eigen::MatrixXd design(const std::vector<Pick>& chosen) const;
  void settle(std::vector<Pick>& chosen) const;  ///< joint amplitudes and gains
  void findRivals(std::vector<Pick>& chosen) const;
  bool open(const Effect* effect, const std::vector<Pick>& chosen) const;

  const LinearRig& rig_;
  const Excitation& seen_;
  std::vector<int> fold_;
  int folds_;
  std::uint64_t seed_;
  Criteria limits_;
  std::vector<const Effect*> effects_;
  std::vector<Candidate> candidates_;
  Eigen::MatrixXd free_;              ///< the candidates' columns without what the base explains
  std::vector<Eigen::MatrixXd> own_;  ///< products of each candidate's free columns among themselves
  Eigen::VectorXd norms_;             ///< squared, of the whole columns
  Left base_;                         ///< with nothing chosen
  mutable ColumnMemo known_;
};

}  // namespace breakaway
