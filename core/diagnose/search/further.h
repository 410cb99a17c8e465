// What the screen could not see may still show in the simulation.
#pragma once

#include <vector>

#include "diagnose/search/adoption.h"
#include "diagnose/search/search.h"
#include "diagnose/search/set_fits.h"

namespace breakaway {

/// Looks for one effect more. Keeps references to what it is made from.
class Further {
 public:
  Further(const SearchInput& input, const SetFits& fits, const Screen& screen, const Adoption& adoption)
      : input_(input), limits_(input.criteria), fits_(fits), screen_(screen), adoption_(adoption) {}

  /// The effect that takes away most beside those of the result, in which a fit far from the answer goes on first.
  /// `picks`: what the screen found. Returns whether there is one.
  bool find(SearchResult& result, std::vector<Pick> picks) const;

 private:
  Pick simulatedBest(const Effect& effect, const Model& model, const Pick& screened) const;
  FitResult withOtherEnd(FitResult fit, const Pick& one, double left) const;
  bool pushes(const SearchResult& before, const FitResult& fit, const Effect& effect) const;
  bool leavesNothing(const FitResult& without, const FitResult& with) const;
  std::vector<Pick> sloped(const SearchResult& result) const;
  FitResult withoutImplausible(FitResult fit) const;

  const SearchInput& input_;
  const Criteria& limits_;
  const SetFits& fits_;
  const Screen& screen_;
  const Adoption& adoption_;
};

}  // namespace breakaway
