// Which effects are missing: the linear screen proposes, simulated windows decide.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/search/screen.h"
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
  std::function<void(const std::vector<Pick>&)> named;  ///< called once the screen has its names
  std::vector<double> windowWeights;                    ///< of split.train; empty: all 1
};

struct Chosen {
  const Effect* effect = nullptr;
  double pValue = 1.0;                ///< family-wise
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

/// The screen's effects are fitted together by simulation. An effect stays when without it the cross-validated error of
/// the simulated training windows is at least 3 % higher with a 95 % interval above zero. Others are tried by
/// simulation in its place: one that does better takes it, one that comes within two standard errors is a rival. What
/// the screen could not see (standstill is no regression) may still enter by simulation, if it takes away at least
/// half of the error. Held-out data is never looked at.
Result<SearchResult> searchEffects(const SearchInput& input, const std::vector<Model>& starts);

/// The effects named, each at its best shape by the screen, fitted together with the base.
Result<FitResult> fitNamed(const SearchInput& input, const std::vector<Model>& starts,
                           const std::vector<std::string>& names);

}  // namespace breakaway
