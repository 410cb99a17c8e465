#include "diagnose/search/search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/cross_validation.h"
#include "diagnose/fit/size_profile.h"
#include "diagnose/search/adoption.h"
#include "diagnose/search/foresight.h"
#include "diagnose/search/further.h"
#include "diagnose/search/rivals.h"
#include "diagnose/search/set_fits.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

void Chosen::keepTried(const Effect* other, const FitResult& fit) {
  const double square = mean(fit.windowSquares);
  const auto known =
      std::find_if(tried.begin(), tried.end(), [other](const InPlace& one) { return one.effect == other; });
  if (known == tried.end())
    tried.push_back({other, fit.model, square});
  else if (square < known->square)
    *known = {other, fit.model, square};
}

bool contains(const std::vector<Chosen>& chosen, const Effect* effect) {
  return std::any_of(chosen.begin(), chosen.end(), [effect](const Chosen& one) { return same(one.effect, effect); });
}

namespace {

constexpr int mostFurther = 3;

class Search {
 public:
  explicit Search(SearchInput input) : input_(std::move(input)) {}

  Result<SearchResult> run(const std::vector<Model>& starts) {
    SearchResult result;
    input_.say(0.05, message("fitting the base model"));
    result.base = fitBase(input_, starts);
    input_.windowWeights = robustWeights(result.base.windowSquares);
    result.base = fitModel(input_, result.base.model, 10);
    result.best = result.base;
    const bool away = input_.mayTurnToTorque && runAway(result.base.model, starts.front(), limits());
    input_.say(0.2, message("looking for what is missing"));
    input_.seen.inertia = physicsInertia(result.base.model);
    const auto motions = recordedMotions(result.base.model, input_.tracks);
    const LinearRig steadyRig(result.base.model, input_.tracks, input_.split.train, Torque::steady, motions);
    const Screening steady(input_, steadyRig, input_.effects);
    if (away)
      result.counting = {ErrorIn::torque, input_.split.window_s};
    else if (input_.mayShorten)
      result.counting = betterFor(steady, result.base.model);
    fits_.emplace(input_, result.base);
    if (result.counting && result.counting->errorIn == ErrorIn::torque && loadFollows(result.base, steady.screen))
      result.counting.reset();
    if (result.counting) return result;
    result.adequate = input_.adequate = limits().farOff * worth().floor();
    if (sure(steady.found)) announce(important(steady.found));  // or else what simulation makes of it
    const LinearRig wanderingRig(result.base.model, input_.tracks, input_.split.train, Torque::wandering, motions);
    result.leftByBase = wanderingRig.wander();
    fits_->weighRestarts(result.leftByBase);
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    input_.say(0.35, message("simulating what was found"));
    Adoption adoption(input_, *fits_, wanderingRig);
    const Screening* wandering = adoption.adopt(result, steady);
    const Screen& first = wandering != nullptr ? wandering->screen : steady.screen;
    const bool asSet = !result.chosen.empty();
    if (!asSet) adoption.adoptAlone(result, first);
    fromOtherStarts(result, starts);
    backward(result);
    if (asSet && result.chosen.empty()) {  // one of its members may still be right alone, from a start of its own
      adoption.adoptAlone(result, first);
      backward(result);
    }
    const double before = mean(result.best.windowSquares);
    adoption.adoptBest(result, first);
    adoption.addWaves(result);
    if (mean(result.best.windowSquares) < before) backward(result);
    if (wandering == nullptr) {
      wandering = adoption.extend(result);
      if (wandering != nullptr) backward(result);
    }
    const auto& [screen, found] = wandering != nullptr ? *wandering : steady;
    input_.say(0.45, message("looking for more"));
    const Further further(input_, *fits_, screen, adoption);
    for (int more = 0; more < mostFurther && further.find(result, found.chosen); ++more) backward(result);
    result.cut = input_.enough() && !input_.stop.stop_requested();
    if (result.cut && result.chosen.empty()) return result;
    if (settledOn(result)) announce(result.chosen);
    refine(result);
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    Rivals(input_, *fits_, screen).weigh(result, std::move(left_));
    adoption.listOtherLoads(result);
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    result.left = wanderBeside(wanderingRig, picksOf(result.best.model, screen));
    input_.say(0.85, message("refining"));
    const Model& base = result.base.model;
    const std::vector<double> weights = polishWeights(input_, base, result.best.model);
    result.base = polishModel(input_, base, polishWeights(input_, base, base));
    if (result.chosen.empty()) {
      result.best = result.base;
      return result;
    }
    result.best = polishModel(input_, result.best.model, weights);
    dropIdleWaves(result, weights);
    dropVanished(result, weights);
    return result;
  }

 private:
  const Worth& worth() const { return fits_->worth(); }
  const Criteria& limits() const { return input_.criteria; }
  double physicsInertia(const Model& model) const {
    return model.baseValue(motorNames(model.axis).inertia).value_or(input_.seen.inertia);
  }
  /// How errors are counted better, if the effect is there that explains most alone.
  std::optional<Counting> betterFor(const Screening& steady, const Model& base) const {
    const std::vector<Pick> picks = bestAlone(steady.screen, limits());
    if (picks.empty() || steady.found.leftSquares > (1.0 - limits().farLess) * steady.found.baseSquares)
      return std::nullopt;
    const Pick& most = picks.front();
    const Model rig = withScreenedBase(input_, base, steady.screen.baseCoefficients({most}));
    return betterCounting(input_, base, with(input_, rig, most));
  }
  /// Torque along the motion shows no load behind a spring: such a load keeps the motion from being foreseen, and makes
  /// the inertia that torque shows another one than the whole. Where one follows all, motion is foreseen with it. (One
  /// behind a gap takes ten times as long, and hardly ever follows all.)
  bool loadFollows(const FitResult& base, const Screen& screen) const {
    const SwingingLoads loads(input_, worth(), base.model);
    const std::vector<Pick> picks = SwingingLoads::offered(input_, screen);
    return std::any_of(picks.begin(), picks.end(), [&](const Pick& pick) {
      if (inPlay(pick)) return false;
      const FitResult fit = loads.fitted(pick);
      return fit.usable && plausible(fit.model, input_.seen) && loadFollowsAll(fit, base, limits());
    });
  }
  /// The screen's effects whose part of the residual a simulation is likely to confirm.
  std::vector<Pick> important(const ScreenResult& found) const {
    std::vector<Pick> picks = asEffects(found.chosen);
    const bool atFloor = worth().baseAtFloor();
    // If the position is at its floor, a current may still show an effect, if that makes up most of the residual.
    const double least = (atFloor ? limits().half : limits().farLess) * found.baseSquares;
    if (atFloor && !input_.seen.currentSeen) return {};
    std::erase_if(picks, [&](const Pick& one) {
      return one.gain < least || !plausible(*one.effect, one.parameters, input_.seen);
    });
    return picks;
  }

  /// Whether a simulation will hardly overrule the screen: one name explains most, or the base is at the floor.
  bool sure(const ScreenResult& found) const {
    const std::vector<Pick> picks = important(found);
    if (picks.empty()) {
      return worth().baseAtFloor() && std::all_of(found.chosen.begin(), found.chosen.end(), [&](const Pick& one) {
               return one.gain < limits().farLess * found.baseSquares;
             });
    }
    if (picks.size() > 1 || picks.front().gain < limits().half * found.baseSquares || !picks.front().rivals.empty())
      return false;
    // Only the simulation tells of effects at standstill and of loads with a motion of their own.
    const Effect& one = *picks.front().effect;
    const auto alike = one.lookAlikes();
    return !swings(picks.front()) && std::none_of(alike.begin(), alike.end(), [](std::string_view name) {
      return findEffect(name)->growsAtRest();
    });
  }
  /// Whether later steps will hardly change the names: there are none, or they explain most and leave little.
  bool settledOn(const SearchResult& result) const {
    return result.chosen.empty() ||
           (worth().floors(result.best) < limits().settled &&
            mean(result.best.windowSquares) < limits().farLess * mean(result.base.windowSquares));
  }
  template <typename One>
  void announce(const std::vector<One>& those) {
    if (!input_.named || std::exchange(announced_, true)) return;
    std::vector<const Effect*> effects;
    effects.reserve(those.size());
    for (const One& one : those) effects.push_back(one.effect);
    input_.named(effects);
  }

  /// What was found may have been missing so much that the base model has ended in another valley: where much is left,
  /// each start once more, with it.
  void fromOtherStarts(SearchResult& result, const std::vector<Model>& starts) const {
    if (result.chosen.empty() || remembers(result.best.model) || worth().floors(result.best) <= limits().farOff) return;
    for (const Model& start : starts) {
      if (input_.enough()) return;
      Model model = result.best.model;
      for (Parameter& one : model.base) {
        if (const auto value = start.baseValue(one.name)) one.value = *value;
      }
      FitResult fit = fitModel(input_, model, 8);
      if (fit.usable && plausible(fit.model, input_.seen) &&
          mean(fit.windowSquares) < limits().clearlyLess * mean(result.best.windowSquares))
        result.best = std::move(fit);
    }
  }

  /// Held parameters are compared once everything else fits.
  void refine(SearchResult& result) const {
    if (remembers(result.best.model)) return;
    for (const Model& model : variantsOf(input_, result.best.model)) {
      if (input_.enough()) return;
      FitResult fit = fitModel(input_, model, 8);
      if (fit.usable && mean(fit.windowSquares) < mean(result.best.windowSquares)) result.best = std::move(fit);
    }
  }

  /// Drops effects that the others make superfluous, the least important ones first, and sets what the others are
  /// worth.
  void backward(SearchResult& result) {
    for (bool changed = true; changed && !input_.stop.stop_requested();) {
      changed = false;
      left_.assign(result.chosen.size(), {});
      for (size_t k = result.chosen.size(); k-- > 0 && !changed;) {
        FitResult fit = fitModel(input_, without(result.best.model, *result.chosen[k].effect), 8);
        if (result.chosen.size() == 1) {  // the effect may have led the base model where it hadn't come to by itself
          if (fit.usable && mean(fit.windowSquares) < limits().hardlyLess * mean(result.base.windowSquares))
            result.base = fit;
          else
            fit = result.base;
        }
        const double back = mean(fit.windowSquares) - mean(result.best.windowSquares);
        const bool needed = fits_->helps(fit, result.best) && worth().material(fit, result.best);
        if (needed && isMoreThanNothing(fit, result.best, *result.chosen[k].effect)) {
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

  /// Whether most of the error comes back without the effect, or its size can be told from zero.
  bool isMoreThanNothing(const FitResult& without, const FitResult& with, const Effect& effect) const {
    if (isClear(without, with, effect) || !vanishes(with.model, effect)) return true;
    if (effect.happensOnce() || !(with.rmse < input_.adequate)) return false;
    const auto& terms = with.model.effects;
    const auto isOfIt = [&effect](const EffectTerm& term) { return term.effect == effect.name(); };
    const auto first = std::find_if(terms.begin(), terms.end(), isOfIt);
    // Without several waves more comes back than one of them makes.
    return std::count_if(first, terms.end(), isOfIt) == 1 &&
           excludesZero(with, static_cast<size_t>(first - terms.begin()), without);
  }

  /// Whether most of the error comes back without the effect. If it happens once, this doesn't count: it may stand for
  /// a single window's start, and its size has to differ from zero.
  bool isClear(const FitResult& without, const FitResult& with, const Effect& effect) const {
    return mean(with.windowSquares) < limits().half * mean(without.windowSquares) && !effect.happensOnce();
  }

  /// Drops effects beside others if the last refinement leaves them a size that may be zero, and if hardly any error
  /// comes back without them.
  void dropVanished(SearchResult& result, const std::vector<double>& weights) const {
    for (size_t k = result.chosen.size(); k-- > 0 && result.chosen.size() > 1;) {
      const Effect& effect = *result.chosen[k].effect;
      if (!vanishes(result.best.model, effect)) continue;
      FitResult fit = polishModel(input_, without(result.best.model, effect), weights);
      if (!fit.usable || isMoreThanNothing(fit, result.best, effect)) continue;
      result.best = std::move(fit);
      result.chosen.erase(result.chosen.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

  /// Drops further waves of an effect if their amplitude may be zero and they take hardly anything away.
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
      if (fit.usable && mean(fit.windowSquares) < limits().hardlyMore() * mean(result.best.windowSquares))
        result.best = std::move(fit);
    }
  }

  SearchInput input_;
  std::optional<SetFits> fits_;  ///< once the base model is fitted
  std::vector<FitResult> left_;  ///< without each chosen effect
  bool announced_ = false;
};

}  // namespace

Result<SearchResult> searchEffects(const SearchInput& input, const std::vector<Model>& starts) {
  return Search(input).run(starts);
}

}  // namespace breakaway
