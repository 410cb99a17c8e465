// What of a screening a simulation adopts: a set, one effect alone, or a load with a motion of its own.
#pragma once

#include <optional>
#include <vector>

#include "diagnose/search/screening.h"
#include "diagnose/search/search.h"
#include "diagnose/search/set_fits.h"

namespace breakaway {

/// Adopts into results that begin with the base model. Keeps references to what it is made from.
class Adoption {
 public:
  /// `wandering`: the rig whose torque is taken for noisy.
  Adoption(const SearchInput& input, SetFits& fits, const LinearRig& wandering)
      : input_(input), limits_(input.criteria), fits_(fits), wanderingRig_(wandering) {}

  /// The screen's set, or a load whose motion explains more than a set that leaves much open. Returns the screening
  /// that takes the torque for noisy, where that has led further, else null.
  const Screening* adopt(SearchResult& result, const Screening& steady);
  /// The first that helps of those that explain most alone, if any does.
  void adoptAlone(SearchResult& result, const Screen& screen) const;
  /// Where what was adopted is far off: of all effects the one by which a simulation errs least, if that alone leaves
  /// less than half of the base's error and clearly less than what was adopted, or two of them, if they leave less than
  /// half of what the better one does. Along a motion that the base doesn't foresee a regression is misled.
  void adoptBest(SearchResult& result, const Screen& screen) const;
  /// Further terms that are likely beside those that were chosen, where much is left.
  void addWaves(SearchResult& result) const;
  /// Where a set leaves much beside what it explains, the larger set that the screen finds if the torque wanders, which
  /// tells waves of several orders better, and that screening; null if that is no better.
  const Screening* extend(SearchResult& result);

  /// Whether a load is worth trying beside others: what one that did nothing alone takes from what others leave is
  /// hardly its own.
  bool mayStillSwing(const Effect* load) const;
  /// Loads that explained the motion about as well as one that was chosen in the end are its rivals.
  void listOtherLoads(SearchResult& result) const;

 private:
  struct Wandering {
    Screening screening;
    SearchResult set;
  };

  struct Tried {
    const Effect* effect;
    FitResult fit;
  };

  std::vector<Tried> eachAlone(const FitResult& base, const Screen& screen) const;
  Pick pickOf(const Screen& screen, const Effect& effect) const;
  FitResult alone(const FitResult& base, const Screen& screen, const Effect& effect) const;
  FitResult toItsEnd(FitResult fit, double before) const;
  std::optional<SearchResult> bestTwo(const FitResult& base, const std::vector<Tried>& tried) const;
  FitResult withFurtherWaves(FitResult fit, const Effect& effect) const;
  static void sortByLeft(std::vector<Tried>& tried);
  void adoptSet(SearchResult& result, const Screen& screen, std::vector<Pick> picks) const;
  void adoptLoad(SearchResult& result, const Screen& screen);
  const Screening* lookAgain(SearchResult& set);
  const Wandering& wandering(const SearchResult& base);
  bool isLikely(const Effect* load) const;

  const SearchInput& input_;
  const Criteria& limits_;
  SetFits& fits_;
  const LinearRig& wanderingRig_;
  std::optional<Wandering> wandering_;  ///< once asked for
  std::vector<InPlace> likelyLoads_;    ///< that swing, as adoptLoad() found
  bool loadsTried_ = false;
};

}  // namespace breakaway
