#include "diagnose/search/search.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/statistics.h"
#include "diagnose/catalogue.h"
#include "diagnose/fit/cross_validation.h"
#include "diagnose/search/rivals.h"
#include "diagnose/search/set_fits.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

bool contains(const std::vector<Chosen>& chosen, const Effect* effect) {
  return std::any_of(chosen.begin(), chosen.end(), [effect](const Chosen& one) { return same(one.effect, effect); });
}

namespace {

constexpr double largestPValue = 0.01;
constexpr double halfOfAll = 0.5;
constexpr double mostOfAll = 0.6;
constexpr double importantPart = 0.2, noticeable = 0.02, negligible = 0.005;  ///< of the screen's squared residual
constexpr size_t mostTrials = 4;
constexpr double settledFloors = 9.0;  ///< squared error, in squared floors, below which no more is looked for
constexpr double hardlyMore = 1.03, nearlyAlike = 3.0, nearlyNothing = 0.2, clearlyLess = 0.8;  ///< of a squared error

/// An axis has one load side: of effects that each bring one along, the most important stays.
std::vector<Pick> withOneLoad(std::vector<Pick> picks) {
  bool loaded = false;
  std::erase_if(picks, [&loaded](const Pick& one) {
    if (one.effect->detachedInertia(one.parameters) == 0.0) return false;
    return std::exchange(loaded, true);
  });
  return picks;
}

/// One pick of each effect, with the gains of all its waves.
std::vector<Pick> asEffects(const std::vector<Pick>& picks) {
  std::vector<Pick> effects;
  for (const Pick& pick : picks) {
    const auto known = std::find_if(effects.begin(), effects.end(),
                                    [&pick](const Pick& one) { return same(one.effect, pick.effect); });
    if (known == effects.end()) {
      effects.push_back(pick);
    } else {
      known->gain += pick.gain;
    }
  }
  sortByGain(effects);
  return effects;
}

/// The screen's set without loads and without what hardly takes anything away: simulation may still ask for it.
std::vector<Pick> noteworthy(const ScreenResult& found) {
  std::vector<Pick> picks = found.chosen;
  const double least = negligible * found.baseSquares;
  std::vector<Pick> effects = asEffects(picks);
  std::erase_if(effects, [least](const Pick& one) { return one.gain < least; });
  std::erase_if(picks, [&](const Pick& one) { return swings(one) || !contains(effects, one.effect); });
  return picks;
}

/// What the screen finds on a rig.
struct Screening {
  Screening(const SearchInput& input, const LinearRig& rig, const std::vector<const Effect*>& effects)
      : screen(rig, effects, input.seen, input.split.fold, folds, input.seed), found(screen.run()) {}

  Screen screen;
  ScreenResult found;
};

/// A load's own motion can follow any noise of the torque.
std::vector<const Effect*> withoutLoads(const Excitation& seen) {
  std::vector<const Effect*> effects(catalogue().begin(), catalogue().end());
  std::erase_if(effects, [&seen](const Effect* one) {
    const auto shapes = one->shapes(seen);
    return !shapes.empty() && one->loadPeriod_s(shapes.front().front()) > 0.0;
  });
  return effects;
}

/// The likeliest noise of the torque beside the base and `picks`.
TorqueNoise wanderBeside(const LinearRig& wandering, const std::vector<Pick>& picks) {
  Eigen::MatrixXd more(wandering.response().size(), 0);
  for (const Pick& pick : picks) {
    const Eigen::MatrixXd own = wandering.rawColumnsOf(*pick.effect, pick.shape, pick.track);
    more.conservativeResize(Eigen::NoChange, more.cols() + own.cols());
    more.rightCols(own.cols()) = own;
  }
  return wandering.wander(more);
}

class Search {
 public:
  explicit Search(SearchInput input) : input_(std::move(input)) {}

  Result<SearchResult> run(const std::vector<Model>& starts) {
    SearchResult result;
    input_.say(0.05, "fitting the base model");
    result.base = fitBase(input_, starts);
    input_.windowWeights = robustWeights(result.base.windowSquares);
    result.base = fitModel(input_, result.base.model, 10);
    result.best = result.base;
    input_.say(0.2, "looking for what is missing");
    input_.seen.inertia = physicsInertia(result.base.model);
    const auto motions = recordedMotions(result.base.model, input_.tracks);
    const LinearRig steadyRig(result.base.model, input_.tracks, input_.split.train, Torque::steady, motions);
    const LinearRig wanderingRig(result.base.model, input_.tracks, input_.split.train, Torque::wandering, motions);
    const Screening steady(input_, steadyRig, {catalogue().begin(), catalogue().end()});
    result.leftByBase = wanderingRig.noise();
    fits_.emplace(input_, result.base, result.leftByBase);
    if (sure(steady.found)) announce(important(steady.found));  // or else what simulation makes of it
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    input_.say(0.35, "simulating what was found");
    auto wandering = adoptFound(result, steady, wanderingRig);
    const Screen& first = wandering ? wandering->screen : steady.screen;
    const bool asSet = !result.chosen.empty();
    if (!asSet) adoptAlone(result, first);
    backward(result);
    if (asSet && result.chosen.empty()) {  // one of its members may still be right alone, from a start of its own
      adoptAlone(result, first);
      backward(result);
    }
    if (!wandering) wandering = extend(result, wanderingRig);
    const auto& [screen, found] = wandering ? *wandering : steady;
    if (tryMore(result, screen, found.chosen)) backward(result);
    if (settledOn(result)) announce(result.chosen);
    refine(result);
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    Rivals(input_, *fits_, screen).weigh(result, std::move(left_));
    for (Chosen& one : result.chosen) listOtherLoads(one);
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    result.left = wanderBeside(wanderingRig, picksOf(result, screen));
    input_.say(0.85, "refining");
    const Model& base = result.base.model;
    const std::vector<double> weights = polishWeights(input_, base, result.best.model);
    result.base = polishModel(input_, base, polishWeights(input_, base, base));
    if (result.chosen.empty()) {
      result.best = result.base;
      return result;
    }
    result.best = polishModel(input_, result.best.model, weights);
    dropIdleWaves(result, weights);
    return result;
  }

 private:
  const Worth& worth() const { return fits_->worth(); }
  double physicsInertia(const Model& model) const {
    return model.baseValue(motorNames(model.axis).inertia).value_or(input_.seen.inertia);
  }
  /// The screen's effects whose part of the residual a simulation is likely to confirm.
  std::vector<Pick> important(const ScreenResult& found) const {
    std::vector<Pick> picks = asEffects(found.chosen);
    const bool atFloor = worth().baseAtFloor();
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
      return worth().baseAtFloor() && std::all_of(found.chosen.begin(), found.chosen.end(), [&found](const Pick& one) {
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
  /// Whether what comes after will hardly change the names: nothing, or what explains most and leaves little.
  bool settledOn(const SearchResult& result) const {
    return result.chosen.empty() || (worth().floors(result.best) < settledFloors &&
                                     mean(result.best.windowSquares) < nearlyNothing * mean(result.base.windowSquares));
  }
  template <typename One>
  void announce(const std::vector<One>& those) {
    if (!input_.named || std::exchange(announced_, true)) return;
    std::vector<const Effect*> effects;
    effects.reserve(those.size());
    for (const One& one : those) effects.push_back(one.effect);
    input_.named(effects);
  }

  /// The screen's set as a whole, or else its most important members; where much is left, also with rivals in place, or
  /// the most important one alone.
  void adopt(SearchResult& result, const Screen& screen, std::vector<Pick> picks) const {
    for (; !picks.empty(); dropWavesOrLeast(picks)) {
      FitResult fit = fits_->together(screen, picks);
      if (worth().floors(fit) > 4.0) {
        std::vector<std::vector<Pick>> others = exchanged(screen, picks);
        if (picks.size() > 1) others.push_back({picks.front()});  // what goes with it may have led the fit astray
        for (std::vector<Pick>& other : others) {
          FitResult rival = fits_->together(screen, other);
          if (!rival.usable || mean(rival.windowSquares) > 0.7 * mean(fit.windowSquares)) continue;
          fit = std::move(rival);
          picks = std::move(other);
        }
      }
      if (!fits_->helps(result.base, fit)) {
        for (size_t k = 0; k < picks.size(); ++k) {
          if (!plausible(fit.model.effects[k], input_.seen)) picks[k].gain = 0.0;  // the first to go
        }
        continue;
      }
      result.best = std::move(fit);
      for (const Pick& pick : asEffects(picks)) result.chosen.push_back({pick.effect, pick.pValue, 0.0, {}});
      return;
    }
  }

  /// First all further waves, which together take long to fit, and then one pick at a time.
  static void dropWavesOrLeast(std::vector<Pick>& picks) {
    std::vector<Pick> first;
    for (const Pick& pick : picks) {
      if (!contains(first, pick.effect)) first.push_back(pick);
    }
    if (first.size() == picks.size()) {
      dropLeast(picks);
    } else {
      picks = std::move(first);
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
      const auto here = picks.begin() + static_cast<std::ptrdiff_t>(k);
      if (picks[k].rivals.empty() || contains(std::vector<Pick>(picks.begin(), here), picks[k].effect)) continue;
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

  /// The screen's set, or a load whose motion explains more than a set that leaves much open. Returns the screening
  /// that takes the torque for noisy, where that has led further.
  std::unique_ptr<const Screening> adoptFound(SearchResult& result, const Screening& steady,
                                              const LinearRig& wanderingRig) {
    const auto& [screen, found] = steady;
    double part = 0.0;
    bool named = false;
    for (const Pick& one : found.chosen) {
      part += one.gain;
      named = named || (swings(one) && one.gain > noticeable * found.baseSquares);
      if (swings(one) && one.gain > halfOfAll * found.baseSquares) fits_->expectLoads();
    }
    const bool openToLoads = !worth().baseAtFloor() && (named || part <= mostOfAll * found.baseSquares);
    SearchResult set = result;
    if (!named) adopt(set, screen, noteworthy(found));
    auto wandering = lookAgain(set, wanderingRig);
    const bool explained =
        wandering &&
        wanderBeside(wanderingRig, picksOf(set, wandering->screen)).usual(physicsOf(result.base.model).coulomb);
    if (openToLoads && !explained && mean(set.best.windowSquares) > nearlyNothing * mean(result.base.windowSquares)) {
      SearchResult loaded = result;
      adoptLoad(loaded, screen);
      // A load is free at each window's start: beside a set that explains much it has to do better from restarts, too.
      if (!loaded.chosen.empty() &&
          (set.chosen.empty() || !wandering || fits_->clearlyBetterFromRestarts(loaded.best.model, set.best.model))) {
        result = std::move(loaded);
        return nullptr;
      }
    }
    if (named && !wandering) adopt(set, screen, withOneLoad(found.chosen));
    result = std::move(set);
    return wandering;
  }

  /// Where a set leaves much, what the screen finds if the torque wanders; nothing if that is no better.
  std::unique_ptr<const Screening> lookAgain(SearchResult& set, const LinearRig& wanderingRig) const {
    const double left = mean(set.best.windowSquares);
    if (worth().baseAtFloor() || worth().floors(set.best) <= settledFloors ||
        left <= halfOfAll * mean(set.base.windowSquares))
      return nullptr;
    auto wandering = std::make_unique<const Screening>(input_, wanderingRig, withoutLoads(input_.seen));
    SearchResult other = set;
    other.best = other.base;
    other.chosen.clear();
    adopt(other, wandering->screen, noteworthy(wandering->found));
    const double now = mean(other.best.windowSquares);
    const bool current = other.best.currentSquares < clearlyLess * set.best.currentSquares;
    if (now >= (current ? 1.0 : clearlyLess) * left) return nullptr;
    set = std::move(other);
    return wandering;
  }

  /// Where a set leaves much beside what it explains, the larger set that the screen finds if the torque wanders, which
  /// tells waves of several orders better; nothing if that is no better.
  std::unique_ptr<const Screening> extend(SearchResult& result, const LinearRig& wanderingRig) {
    if (result.chosen.empty() || swings(result.best.model) || worth().floors(result.best) <= settledFloors)
      return nullptr;
    auto wandering = std::make_unique<const Screening>(input_, wanderingRig, withoutLoads(input_.seen));
    SearchResult other = result;
    other.best = other.base;
    other.chosen.clear();
    adopt(other, wandering->screen, noteworthy(wandering->found));
    const bool goesOn = contains(other.chosen, result.chosen.front().effect);
    if (!goesOn || mean(other.best.windowSquares) >= clearlyLess * mean(result.best.windowSquares)) return nullptr;
    result = std::move(other);
    backward(result);
    return wandering;
  }

  void adoptLoad(SearchResult& result, const Screen& screen) {
    loadsTried_ = true;
    if (!fits_->loadsAreTried()) return;
    std::vector<std::pair<const Effect*, double>> left;  // squared errors
    const SwingingLoads loads(input_, result.base.model);
    for (const Pick& pick : SwingingLoads::offered(input_, screen)) {
      const Effect* effect = pick.effect;
      FitResult fit = loads.fitted(pick);
      if (!fit.usable || !fits_->helps(result.base, fit)) continue;
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

  static std::vector<Pick> picksOf(const SearchResult& result, const Screen& screen) {
    std::vector<Pick> picks;
    for (const EffectTerm& term : result.best.model.effects) {
      Pick pick = screen.best(*findEffect(term.effect), picks);
      if (!pick.parameters.empty()) picks.push_back(std::move(pick));
    }
    return picks;
  }

  /// What the screen could not see may still show in the simulation.
  bool tryMore(SearchResult& result, const Screen& screen, std::vector<Pick> picks) const {
    std::erase_if(picks, [&](const Pick& one) { return !contains(result.chosen, one.effect); });
    const auto settled = [&] {
      const double left = mean(result.best.windowSquares);
      return worth().floors(result.best) < settledFloors || left < 0.02 * mean(result.base.windowSquares);
    };
    if (settled()) return false;
    if (!remembers(result.best.model)) {  // far from the answer, a fit may have come to no end yet
      FitResult further = fitModel(input_, result.best.model, 8);
      if (further.usable && mean(further.windowSquares) < mean(result.best.windowSquares))
        result.best = std::move(further);
      if (settled()) return false;
    }
    const auto before = worth().validated(result.best);
    const double left = mean(result.best.windowSquares);
    std::vector<Pick> candidates;
    const bool loaded = swings(result.best.model);
    for (const Effect* effect : catalogue()) {
      if (contains(result.chosen, effect) && !effect->mayRepeat(input_.seen)) continue;
      Pick pick = screen.best(*effect, picks);
      if (pick.parameters.empty()) continue;
      // What a load that did nothing alone takes from what others leave is hardly its own.
      if (swings(pick) && (loaded || !fits_->loadsMayShow() || (loadsTried_ && !isLikelyLoad(effect)))) continue;
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
      if (swings(candidate) && winner && worth().floors(*winner) < settledFloors) break;
      FitResult fit = fits_->beside(result.best.model, candidate, left);
      if (!fit.usable || !plausible(fit.model, input_.seen)) continue;
      const auto after = worth().validated(fit);
      const Comparison gain = compare(before, after, input_.seed);
      const double pValue = worth().chance(before, after);
      if (swings(fit.model) && !fits_->helps(result.best, fit)) continue;
      if (!(gain.relative >= best) || gain.interval.low <= sureGain || pValue > largestPValue) continue;
      best = gain.relative;
      winner = std::move(fit);
      chosen = {candidate.effect, pValue, 0.0, {}};
    }
    if (!winner) return false;
    result.best = std::move(*winner);
    if (!contains(result.chosen, chosen.effect)) result.chosen.push_back(chosen);
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
        const bool needed = fits_->helps(fit, result.best) && worth().material(fit, result.best);
        // What happens once may stand for whatever one window's start did: its size has to be told from zero.
        const bool clear = back > halfOfAll * mean(fit.windowSquares) && !result.chosen[k].effect->happensOnce();
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

  /// Of an effect's further waves, those go of which there may be nothing and that hardly take anything away.
  void dropIdleWaves(SearchResult& result, const std::vector<double>& weights) const {
    for (size_t e = result.best.model.effects.size(); e-- > 1;) {
      const auto& terms = result.best.model.effects;
      const auto here = terms.begin() + static_cast<std::ptrdiff_t>(e);
      const Parameter& size = here->parameters.front();
      const bool further =
          std::any_of(terms.begin(), here, [&here](const EffectTerm& one) { return one.effect == here->effect; });
      if (!further || size.low95 > 0.0 || size.high95 < 0.0) continue;
      Model less = result.best.model;
      less.effects.erase(less.effects.begin() + static_cast<std::ptrdiff_t>(e));
      FitResult fit = polishModel(input_, less, weights);
      if (fit.usable && mean(fit.windowSquares) < hardlyMore * mean(result.best.windowSquares))
        result.best = std::move(fit);
    }
  }

  SearchInput input_;
  std::optional<SetFits> fits_;             ///< once the base model is fitted
  std::vector<FitResult> left_;             ///< without each chosen effect
  std::vector<const Effect*> likelyLoads_;  ///< that swing, as adoptLoad() found
  bool loadsTried_ = false, announced_ = false;
};

}  // namespace

Result<SearchResult> searchEffects(const SearchInput& input, const std::vector<Model>& starts) {
  return Search(input).run(starts);
}

}  // namespace breakaway
