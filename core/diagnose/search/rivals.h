// Which other effects would do about as well as those that were chosen: rivals, or the better name.
#pragma once

#include "diagnose/search/search.h"
#include "diagnose/search/set_fits.h"

namespace breakaway {

/// Weighs the effects of a search's result. Keeps references to what it is made from.
class Rivals {
 public:
  Rivals(const SearchInput& input, const SetFits& fits, const Screen& screen)
      : input_(input), limits_(input.criteria), fits_(fits), screen_(screen) {}

  /// Others in the place of each chosen effect: one that does better takes it, one that does as well is listed. `left`:
  /// fits without each chosen effect. The most important effect comes first afterwards.
  void weigh(SearchResult& result, std::vector<FitResult> left) const;

 private:
  void addBest(const Effect& effect, std::vector<Pick>& others) const;
  std::vector<Pick> othersOf(const SearchResult& result, size_t k) const;
  std::vector<Pick> nearlyAsGood(const SearchResult& result, size_t k) const;
  std::vector<Pick> whateverTheScreen(const SearchResult& result, size_t k) const;
  bool listUntried(SearchResult& result, Chosen& chosen, const Effect* rival) const;
  void tryInPlace(SearchResult& result, size_t k, const FitResult& left, const Pick& rival,
                  std::vector<double>& best) const;
  void weighAlone(SearchResult& result) const;
  void askVoltage(SearchResult& result, size_t k) const;
  void askVoltage(SearchResult& result, size_t k, const Effect& offset) const;

  const SearchInput& input_;
  const Criteria& limits_;
  const SetFits& fits_;
  const Screen& screen_;
};

}  // namespace breakaway
