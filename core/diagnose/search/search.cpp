#include "diagnose/search/search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "diagnose/catalogue.h"
#include "diagnose/fit/cross_validation.h"
#include "diagnose/noise_floor.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/search/worth.h"

namespace breakaway {

namespace {

constexpr double largestPValue = 0.01;
constexpr double halfOfAll = 0.5;
constexpr double mostOfAll = 0.6;
constexpr double importantPart = 0.2, noticeable = 0.02, negligible = 0.002;  ///< of the screen's squared residual
constexpr size_t mostTrials = 4;
constexpr double settledFloors = 9.0;  ///< squared error, in squared floors, below which no more is looked for
constexpr double clearlyLess = 0.65, nearlyAlike = 3.0, nearlyNothing = 0.2;  ///< of a squared error
constexpr size_t mostRivals = 3;
constexpr double loadFloors = 2.0;  ///< rms error of restarts, in tolerated ones, from which a load is looked for

bool same(const Effect* a, const Effect* b) {
  return a == b || (!a->twin().empty() && a->twin() == b->name());
}

bool contains(const std::vector<Chosen>& chosen, const Effect* effect) {
  return std::any_of(chosen.begin(), chosen.end(), [effect](const Chosen& one) { return same(one.effect, effect); });
}

/// Whether the effect's amplitude, its first parameter, can't be told from zero.
bool vanishes(const Model& model, const Effect& effect) {
  for (const EffectTerm& term : model.effects) {
    if (term.effect == effect.name())
      return term.parameters.front().low95 < 0.0 && term.parameters.front().high95 > 0.0;
  }
  return true;
}

/// An axis has one load side: of effects that each bring one along, the most important stays.
std::vector<Pick> withOneLoad(std::vector<Pick> picks) {
  bool loaded = false;
  std::erase_if(picks, [&loaded](const Pick& one) {
    if (one.effect->detachedInertia(one.parameters) == 0.0) return false;
    return std::exchange(loaded, true);
  });
  return picks;
}

/// The screen's set without loads and without what hardly takes anything away: simulation may still ask for it.
std::vector<Pick> noteworthy(const ScreenResult& found) {
  std::vector<Pick> picks = found.chosen;
  const double least = negligible * found.baseSquares;
  std::erase_if(picks, [least](const Pick& one) { return swings(one) || one.gain < least; });
  return picks;
}

/// The largest gain first.
void sortByGain(std::vector<Pick>& picks) {
  std::stable_sort(picks.begin(), picks.end(), [](const Pick& a, const Pick& b) { return a.gain > b.gain; });
}

class Search {
 public:
  explicit Search(SearchInput input) : input_(std::move(input)) {}

  Result<SearchResult> run(const std::vector<Model>& starts) {
    SearchResult result;
    say(0.05, "fitting the base model");
    result.base = fitBase(input_, starts);
    input_.windowWeights = robustWeights(result.base.windowSquares);
    result.base = fitModel(input_, result.base.model, 10);
    loadsMayShow_ = restartsErr(result.base.model);
    worth_.emplace(input_, result.base,
                   noiseFloor(result.base.model, input_.tracks, input_.split.trainScore, input_.seed));
    result.best = result.base;
    say(0.2, "looking for what is missing");
    input_.seen.inertia = physicsInertia(result.base.model);
    const LinearRig rig(result.base.model, input_.tracks, input_.split.train);
    const Screen screen(rig, {catalogue().begin(), catalogue().end()}, input_.seen, input_.split.fold, folds,
                        input_.seed);
    const ScreenResult found = screen.run();
    if (sure(found)) announce(important(found));
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    say(0.35, "simulating what was found");
    adoptFound(result, screen, found);
    const bool asSet = !result.chosen.empty();
    if (!asSet) adoptAlone(result, screen);
    backward(result);
    if (asSet && result.chosen.empty()) {  // one of its members may still be right alone, from a start of its own
      adoptAlone(result, screen);
      backward(result);
    }
    if (tryMore(result, screen, found.chosen)) backward(result);
    refine(result);
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    weigh(result, screen);
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    say(0.85, "refining");
    const std::vector<double> weights =
        robustWeights(residualSquares(result.base.model, input_.tracks, input_.split.polish));
    result.base = polishModel(input_, result.base.model, weights);
    result.best = result.chosen.empty() ? result.base : polishModel(input_, result.best.model, weights);
    return result;
  }

 private:
  void say(double progress, const std::string& activity) const {
    if (input_.progress) input_.progress(progress, activity);
  }
  double physicsInertia(const Model& model) const {
    return model.baseValue(motorNames(model.axis).inertia).value_or(input_.seen.inertia);
  }
  /// Whether restarts err by more than sensors and friction that scatters may do: a load that swings or flies leaves
  /// much.
  bool restartsErr(const Model& base) const {
    const auto& windows = input_.split.trainScore;
    const double tolerated = noiseFloor(base, input_.tracks, windows, input_.seed, usualScatter(input_.seen.highSpeed));
    return mean(scoreWindows(base, input_.tracks, windows)) > std::pow(loadFloors * tolerated, 2);
  }
  /// Whether the second model takes away error. A load that swings is free at each window's start, which noise can use,
  /// too: it has to do clearly better from restarts as well, where it isn't.
  bool helps(const FitResult& without, const FitResult& with) const {
    if (!worth_->helps(without, with)) return false;
    return !swings(with.model) || swings(without.model) ||
           (loadsMayShow_ && restartedPart(with.model, without.model) < clearlyLess);
  }
  /// What a model typically leaves of another's squared error when the training windows restart.
  double restartedPart(const Model& model, const Model& ofModel) const {
    return typicalPart(scoreWindows(model, input_.tracks, input_.split.trainScore),
                       scoreWindows(ofModel, input_.tracks, input_.split.trainScore));
  }
  FitResult fitFresh(const Model& start) const { return fitModel(input_, start, 6); }
  /// The screen's effects whose part of the residual a simulation is likely to confirm.
  std::vector<Pick> important(const ScreenResult& found) const {
    std::vector<Pick> picks = found.chosen;
    const bool atFloor = worth_->baseAtFloor();
    // At the position's floor a current may still show something, if that is most of what there is.
    const double least = (atFloor ? halfOfAll : importantPart) * found.baseSquares;
    if (atFloor && !input_.seen.currentSeen) return {};
    std::erase_if(picks, [&](const Pick& one) {
      return one.gain < least || !plausible(*one.effect, one.parameters, input_.seen);
    });
    return picks;
  }

  /// Whether a simulation will hardly overrule the screen's names: one that explains most, or nothing at the floor.
  bool sure(const ScreenResult& found) const {
    const std::vector<Pick> picks = important(found);
    if (picks.empty()) {
      return worth_->baseAtFloor() && std::all_of(found.chosen.begin(), found.chosen.end(), [&found](const Pick& one) {
               return one.gain < importantPart * found.baseSquares;
             });
    }
    if (picks.size() > 1 || picks.front().gain < mostOfAll * found.baseSquares || !picks.front().rivals.empty())
      return false;
    // What acts at standstill, and loads that have a motion of their own, are for the simulation to tell.
    const Effect& one = *picks.front().effect;
    const auto alike = one.lookAlikes();
    return !swings(picks.front()) && std::none_of(alike.begin(), alike.end(), [](std::string_view name) {
      return findEffect(name)->growsAtRest();
    });
  }
  void announce(const std::vector<Pick>& those) const {
    if (!input_.named) return;
    std::vector<const Effect*> effects;
    effects.reserve(those.size());
    for (const Pick& one : those) effects.push_back(one.effect);
    input_.named(effects);
  }

  Model withPicks(const SearchResult& result, const Screen& screen, const std::vector<Pick>& picks) const {
    Model model = withScreenedBase(input_, result.base.model, screen.baseCoefficients(picks));
    for (const Pick& pick : picks) model = with(input_, model, pick);
    return model;
  }

  /// The screen's set as a whole, or else its most important members; where much is left, also with rivals in place, or
  /// the most important one alone.
  void adopt(SearchResult& result, const Screen& screen, std::vector<Pick> picks) const {
    for (; !picks.empty(); dropLeast(picks)) {
      FitResult fit = fitSet(result, screen, picks);
      if (worth_->floors(fit) > 4.0) {
        std::vector<std::vector<Pick>> others = exchanged(screen, picks);
        if (picks.size() > 1) others.push_back({picks.front()});  // what goes with it may have led the fit astray
        for (std::vector<Pick>& other : others) {
          FitResult rival = fitSet(result, screen, other);
          if (!rival.usable || mean(rival.windowSquares) > 0.7 * mean(fit.windowSquares)) continue;
          fit = std::move(rival);
          picks = std::move(other);
        }
      }
      if (!helps(result.base, fit)) {
        for (size_t k = 0; k < picks.size(); ++k) {
          if (!plausible(fit.model.effects[k], input_.seen)) picks[k].gain = 0.0;  // the first to go
        }
        continue;
      }
      result.best = std::move(fit);
      for (const Pick& pick : picks) result.chosen.push_back({pick.effect, pick.pValue, 0.0, {}});
      return;
    }
  }

  static void dropLeast(std::vector<Pick>& picks) {
    const auto nonsense = std::find_if(picks.begin(), picks.end(), [](const Pick& one) { return one.gain <= 0.0; });
    picks.erase(nonsense != picks.end() ? nonsense : picks.end() - 1);
  }

  void adoptAlone(SearchResult& result, const Screen& screen) const {
    for (const Pick& pick : bestAlone(screen)) {
      if (result.chosen.empty()) adopt(result, screen, {pick});
    }
  }

  /// The effects that explain most alone.
  static std::vector<Pick> bestAlone(const Screen& screen) {
    std::vector<Pick> best;
    for (const Effect* effect : catalogue()) {
      Pick pick = screen.best(*effect, {});
      pick.pValue = largestPValue;
      if (!pick.parameters.empty()) best.push_back(std::move(pick));
    }
    sortByGain(best);
    const double least = best.empty() ? 0.0 : halfOfAll * best.front().gain;
    std::erase_if(best, [least](const Pick& one) { return one.gain < least; });
    if (best.size() > mostTrials) best.resize(mostTrials);
    return best;
  }

  /// The set with one member at a time exchanged for its first rival.
  static std::vector<std::vector<Pick>> exchanged(const Screen& screen, const std::vector<Pick>& picks) {
    std::vector<std::vector<Pick>> sets;
    for (size_t k = 0; k < picks.size(); ++k) {
      if (picks[k].rivals.empty()) continue;
      std::vector<Pick> others = picks;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      Pick rival = screen.best(*picks[k].rivals.front(), others);
      if (rival.parameters.empty()) continue;
      rival.pValue = picks[k].pValue;
      sets.push_back(picks);
      sets.back()[k] = std::move(rival);
    }
    return sets;
  }

  /// The screen's set, or a load whose motion explains more than a set that leaves much open.
  void adoptFound(SearchResult& result, const Screen& screen, const ScreenResult& found) {
    double explained = 0.0;
    bool named = false;
    for (const Pick& one : found.chosen) {
      explained += one.gain;
      named = named || (swings(one) && one.gain > noticeable * found.baseSquares);
    }
    const bool openToLoads = !worth_->baseAtFloor() && (named || explained <= mostOfAll * found.baseSquares);
    SearchResult set = result;
    if (!named) adopt(set, screen, noteworthy(found));
    if (openToLoads && mean(set.best.windowSquares) > nearlyNothing * mean(result.base.windowSquares))
      adoptLoad(result, screen);
    if (!result.chosen.empty()) return;
    if (named) adopt(set, screen, withOneLoad(found.chosen));
    result = std::move(set);
  }

  void adoptLoad(SearchResult& result, const Screen& screen) {
    loadsTried_ = true;
    if (!loadsMayShow_) return;
    std::vector<std::pair<const Effect*, double>> left;  // squared errors
    const SwingingLoads loads(input_, result.base.model);
    for (const Pick& pick : SwingingLoads::offered(input_, screen)) {
      const Effect* effect = pick.effect;
      FitResult fit = loads.fitted(pick);
      if (!fit.usable || !helps(result.base, fit)) continue;
      const double own = mean(fit.windowSquares);
      left.emplace_back(effect, own);
      if (own >= mean(result.best.windowSquares)) continue;
      result.best = std::move(fit);
      result.chosen = {{effect, largestPValue, 0.0, {}}};
    }
    for (const auto& [effect, own] : left) {
      if (own < nearlyAlike * mean(result.best.windowSquares)) likelyLoads_.push_back(effect);
    }
  }

  bool isLikelyLoad(const Effect* effect) const {
    return std::find(likelyLoads_.begin(), likelyLoads_.end(), effect) != likelyLoads_.end();
  }
  /// A load that explained the motion about as well as the one that was chosen in the end.
  void listOtherLoads(Chosen& chosen) const {
    if (!isLikelyLoad(chosen.effect)) return;
    for (const Effect* other : likelyLoads_) {
      const bool listed = std::find(chosen.rivals.begin(), chosen.rivals.end(), other) != chosen.rivals.end();
      if (other != chosen.effect && !listed) chosen.rivals.push_back(other);
    }
  }

  FitResult fitSet(const SearchResult& result, const Screen& screen, const std::vector<Pick>& picks) const {
    const Model start = withPicks(result, screen, picks);
    FitResult fit = fitFresh(start);
    if (fit.usable && mean(fit.windowSquares) < 0.6 * mean(result.base.windowSquares)) return fit;
    // Hidden states are slow to fit: several effects at once get one more start only.
    std::vector<Model> starts = picks.size() > 1 && remembers(start) ? std::vector<Model>{} : variantsOf(start);
    starts.push_back(fitShort(input_, start));
    for (const Model& other : starts) {
      FitResult slow = fitFresh(other);
      if (slow.usable && mean(slow.windowSquares) < mean(fit.windowSquares)) fit = std::move(slow);
    }
    return fit;
  }

  FitResult fitBeside(const Model& model, const Pick& pick, double left) const {
    if (swings(pick)) return SwingingLoads(input_, model).fitted(pick);
    const Model start = with(input_, model, pick);
    FitResult fit = fitFresh(start);
    if (!fit.usable || mean(fit.windowSquares) > (1.0 - clearGain) * left) fit = fitFresh(fitShort(input_, start));
    return fit;
  }

  /// What the screen could not see may still show in the simulation.
  bool tryMore(SearchResult& result, const Screen& screen, std::vector<Pick> picks) const {
    std::erase_if(picks, [&](const Pick& one) { return !contains(result.chosen, one.effect); });
    const auto settled = [&] {
      const double left = mean(result.best.windowSquares);
      return worth_->floors(result.best) < settledFloors || left < 0.02 * mean(result.base.windowSquares);
    };
    if (settled()) return false;
    if (!remembers(result.best.model)) {  // far from the answer, a fit may have come to no end yet
      FitResult further = fitModel(input_, result.best.model, 8);
      if (further.usable && mean(further.windowSquares) < mean(result.best.windowSquares))
        result.best = std::move(further);
      if (settled()) return false;
    }
    const auto before = worth_->validated(result.best);
    const double left = mean(result.best.windowSquares);
    std::vector<Pick> candidates;
    const bool loaded = swings(result.best.model);
    for (const Effect* effect : catalogue()) {
      if (contains(result.chosen, effect)) continue;
      Pick pick = screen.best(*effect, picks);
      if (pick.parameters.empty()) continue;
      // What a load that did nothing alone takes from what others leave is hardly its own.
      if (swings(pick) && (loaded || (loadsTried_ && !isLikelyLoad(effect)))) continue;
      candidates.push_back(std::move(pick));
    }
    sortByGain(candidates);
    // What acts around standstill hardly shows in a regression. Loads take long: they come last, and one is enough.
    const auto loads =
        std::stable_partition(candidates.begin(), candidates.end(), [](const Pick& one) { return !swings(one); });
    std::stable_partition(candidates.begin(), loads, [](const Pick& one) { return one.effect->growsAtRest(); });
    const size_t most = remembers(result.best.model) ? 1 : mostTrials;  // hidden states are slow to fit
    if (loads != candidates.end()) candidates.erase(loads + 1, candidates.end());
    const auto skipped =
        loads - candidates.begin() > static_cast<std::ptrdiff_t>(most) ? candidates.begin() + most : loads;
    candidates.erase(skipped, loads);
    std::optional<FitResult> winner;
    Chosen chosen;
    double best = 2.0 * sureGain;
    for (const Pick& candidate : candidates) {
      if (swings(candidate) && winner && worth_->floors(*winner) < settledFloors) break;
      FitResult fit = fitBeside(result.best.model, candidate, left);
      if (!fit.usable || !plausible(fit.model, input_.seen)) continue;
      const auto after = worth_->validated(fit);
      const Comparison gain = compare(before, after, input_.seed);
      const double pValue = worth_->chance(before, after);
      if (swings(fit.model) && !helps(result.best, fit)) continue;
      if (!(gain.relative >= best) || gain.interval.low <= sureGain || pValue > largestPValue) continue;
      best = gain.relative;
      winner = std::move(fit);
      chosen = {candidate.effect, pValue, 0.0, {}};
    }
    if (!winner) return false;
    result.best = std::move(*winner);
    result.chosen.push_back(chosen);
    return true;
  }

  /// Held parameters are compared once everything else fits.
  void refine(SearchResult& result) const {
    if (remembers(result.best.model)) return;
    for (const Model& model : variantsOf(result.best.model)) {
      FitResult fit = fitModel(input_, model, 8);
      if (fit.usable && mean(fit.windowSquares) < mean(result.best.windowSquares)) result.best = std::move(fit);
    }
  }

  /// An effect that the others make superfluous goes, the least important ones first; of those that stay, what they are
  /// worth.
  void backward(SearchResult& result) {
    for (bool changed = true; changed && !input_.stop.stop_requested();) {
      changed = false;
      left_.assign(result.chosen.size(), {});
      for (size_t k = result.chosen.size(); k-- > 0 && !changed;) {
        FitResult fit = result.chosen.size() == 1
                            ? result.base
                            : fitModel(input_, without(result.best.model, *result.chosen[k].effect), 8);
        const double back = mean(fit.windowSquares) - mean(result.best.windowSquares);
        const bool needed = helps(fit, result.best) && worth_->material(fit, result.best);
        // What happens once may stand for whatever one window's start did: its size has to be told from zero.
        const bool clear = back > clearGain * mean(fit.windowSquares) && !result.chosen[k].effect->happensOnce();
        if (needed && (clear || !vanishes(result.best.model, *result.chosen[k].effect))) {
          result.chosen[k].marginal = std::max(0.0, back);
          left_[k] = std::move(fit);
          continue;
        }
        result.best = std::move(fit);
        result.chosen.erase(result.chosen.begin() + static_cast<std::ptrdiff_t>(k));
        changed = true;
      }
    }
  }

  /// Effects that the screen finds nearly as good as the chosen one, beside the other chosen ones.
  std::vector<Pick> nearlyAsGood(const SearchResult& result, const Screen& screen, size_t k) const {
    std::vector<Pick> others, candidates;
    for (size_t j = 0; j < result.chosen.size(); ++j) {
      if (j != k) others.push_back(screen.best(*result.chosen[j].effect, others));
    }
    std::erase_if(others, [](const Pick& one) { return one.parameters.empty(); });
    const double own = screen.best(*result.chosen[k].effect, others).gain;
    const auto alike = result.chosen[k].effect->lookAlikes();
    for (const Effect* effect : catalogue()) {
      if (contains(result.chosen, effect)) continue;
      Pick pick = screen.best(*effect, others);
      const bool listed = std::find(alike.begin(), alike.end(), effect->name()) != alike.end();
      if (pick.parameters.empty() || pick.gain < (listed ? 0.7 : 0.8) * own) continue;
      candidates.push_back(std::move(pick));
    }
    sortByGain(candidates);
    if (candidates.size() > mostRivals) candidates.resize(mostRivals);
    return candidates;
  }

  /// Tries a rival in the place of a chosen effect; `best` are the validated errors of the best model.
  void tryInPlace(SearchResult& result, size_t k, const Pick& rival, std::vector<double>& best) const {
    Chosen& chosen = result.chosen[k];
    // Which of two loads it is, short windows tell better than long ones.
    const bool exchange = swings(result.best.model) && !swings(left_[k].model);
    if (swings(rival) && (exchange || !loadsMayShow_)) return;
    FitResult fit = fitFresh(with(input_, left_[k].model, rival));
    if (!fit.usable || !plausible(fit.model, input_.seen)) return;
    const auto errors = worth_->validated(fit);
    if (!std::isfinite(mean(errors))) return;
    const Comparison ahead = compare(errors, best, input_.seed);
    // Skewed errors hide a clear difference from the t-value: the sign-flip test sees it.
    const bool clearlyWorse = (ahead.relative > 0.25 && signFlipPValue(errors, best, input_.seed) <= 0.02) ||
                              (ahead.relative > 0.5 && quantile(errors, 0.5) > 1.5 * quantile(best, 0.5));
    const bool freer = swings(fit.model) && !swings(result.best.model);
    // Folds may mislead where the form isn't quite right: what fits all windows far worse is no better name.
    const bool better = ahead.inErrors < -2.0 && mean(errors) < 0.9 * mean(best) &&
                        mean(fit.windowSquares) < 1.5 * mean(result.best.windowSquares) &&
                        (!freer || restartedPart(fit.model, result.best.model) < clearlyLess);
    if (!better && (ahead.inErrors >= 2.0 || clearlyWorse)) return;
    // A push at a time of its own explains whatever happened then: physics that does as well is the better name.
    const bool physics = chosen.effect->happensOnce() && !rival.effect->happensOnce();
    if (!better && !physics) {
      chosen.rivals.push_back(rival.effect);
      return;
    }
    if (better) {
      chosen.marginal = std::max(0.0, mean(left_[k].windowSquares) - mean(fit.windowSquares));
      chosen.rivals.clear();
    } else {
      chosen.rivals.push_back(chosen.effect);
    }
    chosen.effect = rival.effect;
    result.best = std::move(fit);
    best = errors;
  }

  /// Beside other findings a name may rest on how they were chosen: a look-alike that does as well alone is a rival.
  void weighAlone(SearchResult& result, const Screen& screen) const {
    Chosen& first = result.chosen.front();
    const auto aloneWith = [&](const Pick& pick) {
      return pick.parameters.empty() ? FitResult{} : fitSet(result, screen, {pick});
    };
    const Pick ownPick = screen.best(*first.effect, {});
    std::optional<double> own;  // squared error; the fits themselves are large
    for (const std::string_view name : first.effect->lookAlikes()) {
      const Effect* alike = findEffect(name);
      const bool known = std::find(first.rivals.begin(), first.rivals.end(), alike) != first.rivals.end();
      if (known || contains(result.chosen, alike) || alike->memory() > 0) continue;
      const Pick pick = screen.best(*alike, {});
      if (pick.gain < halfOfAll * ownPick.gain) continue;
      if (!own) {
        const FitResult fit = aloneWith(ownPick);
        if (!fit.usable || !worth_->helps(result.base, fit)) return;
        own = mean(fit.windowSquares);
      }
      const FitResult rival = aloneWith(pick);
      if (!rival.usable || !plausible(rival.model, input_.seen)) continue;
      // Of as many parameters, so that the errors can be compared as they are.
      if (mean(rival.windowSquares) <= *own) first.rivals.push_back(alike);
    }
  }

  /// The rivals of each chosen effect: others in its place.
  void weigh(SearchResult& result, const Screen& screen) {
    auto best = worth_->validated(result.best);
    for (size_t k = 0; k < result.chosen.size(); ++k) {
      if (input_.stop.stop_requested()) return;
      say(0.5 + 0.3 * static_cast<double>(k) / static_cast<double>(result.chosen.size()), "weighing rivals");
      for (const Pick& rival : nearlyAsGood(result, screen, k)) tryInPlace(result, k, rival, best);
      if (const Effect* twin = findEffect(result.chosen[k].effect->twin())) result.chosen[k].rivals.push_back(twin);
    }
    std::stable_sort(result.chosen.begin(), result.chosen.end(),
                     [](const Chosen& a, const Chosen& b) { return a.marginal > b.marginal; });
    left_.clear();  // they are large, and no longer needed
    if (result.chosen.size() > 1) weighAlone(result, screen);
    for (Chosen& one : result.chosen) listOtherLoads(one);
  }

  SearchInput input_;
  std::optional<Worth> worth_;              ///< once the base model is fitted
  std::vector<FitResult> left_;             ///< without each chosen effect
  std::vector<const Effect*> likelyLoads_;  ///< that swing, as adoptLoad() found
  bool loadsMayShow_ = false;               ///< by the base model's restarts
  bool loadsTried_ = false;
};

}  // namespace

Result<SearchResult> searchEffects(const SearchInput& input, const std::vector<Model>& starts) {
  return Search(input).run(starts);
}

}  // namespace breakaway
