// Which effects are missing: forward selection by simulated windows, backward elimination, and the rivals of what was
// chosen.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "diagnose/score_test.h"
#include "diagnose/split.h"

namespace breakaway {

/// What a search runs on.
struct SearchInput {
  const std::vector<Track>& tracks;
  const Split& split;
  std::vector<std::string> held;  ///< base parameters that are trusted
  Excitation seen;
  std::uint64_t seed = 1;
  std::stop_token stop;
  std::function<void(double, const std::string&)> progress;
  std::vector<double> windowWeights;  ///< of split.train; empty: all 1
  std::vector<Track> training;        ///< what inverse models may see: tracks whose held-out rows are masked
};

struct Chosen {
  const Effect* effect = nullptr;
  double pValue = 1.0;                ///< family-wise, when it entered or by its score without it
  double marginal = 0.0;              ///< squared error that comes back when it is left out, rad² or m²
  std::vector<const Effect*> rivals;  ///< others that do about as well in its place; twins included
};

struct SearchResult {
  FitResult base;
  FitResult best;
  std::vector<Chosen> chosen;  ///< in order of importance
};

/// A fit of `model` to the training windows.
FitResult fitModel(const SearchInput& input, const Model& model, int iterations = 20);

/// The base model: the best of the fits from each start.
FitResult fitBase(const SearchInput& input, const std::vector<Model>& starts);

/// The last refinement, on the overlapping windows.
FitResult polishModel(const SearchInput& input, const Model& model, const std::vector<double>& windowWeights = {});

/// An effect enters when the family-wise p-value of its score (or, where it has no shape to choose or improves by more
/// than 30 %, of its windows' errors after the fit, times the number of candidates) is at most 0.01, and the
/// cross-validated error of the training windows falls by at least 3 % (and 1 % of the base model's) with a 95 %
/// interval above zero. Where no single effect does any more, the set that the inverse model proposes is
/// tried as a whole, with the same gates. An effect leaves again when the error without it is as good. A rival is an
/// effect that, refitted in the chosen one's place, comes within two standard errors of it in cross-validation.
/// Held-out data is never looked at.
Result<SearchResult> searchEffects(const SearchInput& input, const std::vector<Model>& starts);

/// The effects named, each at its best shape by the score test, fitted together with the base.
Result<FitResult> fitNamed(const SearchInput& input, const std::vector<Model>& starts,
                           const std::vector<std::string>& names);

}  // namespace breakaway
