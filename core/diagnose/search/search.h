// Which effects are missing: the linear screen proposes, simulated windows decide.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "base/result.h"
#include "diagnose/search/foresight.h"
#include "diagnose/search/model_fit.h"

namespace breakaway {

/// What an effect made of the training windows in the place of another one.
struct InPlace {
  const Effect* effect = nullptr;
  Model model;
  double square = 0.0;  ///< mean squared error that it left, rad² or m²
};

struct Chosen {
  const Effect* effect = nullptr;
  double pValue = 1.0;                ///< family-wise
  double marginal = 0.0;              ///< squared error that comes back when it is left out, rad² or m²
  std::vector<const Effect*> rivals;  ///< others that do about as well in its place; twins included
  std::vector<InPlace> tried = {};    ///< all that were fitted in its place, each at its best

  void keepTried(const Effect* other, const FitResult& fit);
};

/// Whether an effect, or its twin, is among the chosen ones.
bool contains(const std::vector<Chosen>& chosen, const Effect* effect);

struct SearchResult {
  /// If given, no more than the base was fitted: errors have to be counted so.
  std::optional<Counting> counting;
  FitResult base;
  FitResult best;
  std::vector<Chosen> chosen;  ///< in order of importance
  /// Whose place the only effect took, and the fits with them, the latest last: the better names if its size, in the
  /// end, says nothing.
  std::vector<std::pair<Chosen, FitResult>> displaced = {};
  TorqueNoise left;        ///< what base and chosen leave, taken for a torque that wanders
  TorqueNoise leftByBase;  ///< what the base leaves
  double adequate = std::numeric_limits<double>::infinity();  ///< SearchInput::adequate
  bool cut = false;                                           ///< the time was over before all was looked for
  bool unweighed = false;  ///< and before all rivals were tried: those that weren't are listed
};

/// The screen's effects are fitted together by simulation. An effect stays when without it the cross-validated error of
/// the simulated training windows is at least 3 % higher with a 95 % interval above zero. Others are tried by
/// simulation in its place: one that does better takes it, one that comes within two standard errors is a rival. What
/// the screen could not see (standstill is no regression) may still enter by simulation, if it takes away at least
/// half of the error. Held-out data is never looked at.
Result<SearchResult> searchEffects(const SearchInput& input, const std::vector<Model>& starts);

}  // namespace breakaway
