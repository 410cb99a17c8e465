#include "diagnose/search/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "diagnose/catalogue.h"
#include "diagnose/effects/all.h"
#include "diagnose/fit/cross_validation.h"
#include "diagnose/noise_floor.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr double largestPValue = 0.01;
constexpr double leastImprovement = 0.03;
constexpr double clearImprovement = 0.2;
constexpr double clearOfCurrent = 0.35;  ///< of its squared error
constexpr double halfOfAll = 0.5;
constexpr double surelyMore = 0.15;    ///< of the error, by the interval's lower end
constexpr double importantPart = 0.2;  ///< of the screen's squared residual
constexpr double materialFloors = 1.6;
constexpr double leastShare = 0.01;  ///< of the base model's squared error
constexpr double spreadFloors = 0.3;
constexpr double fewWindowsFloors = 4.0;
constexpr double leastFloors = 0.8;  ///< of the squared floor
constexpr size_t mostTrials = 4;
constexpr size_t mostRivals = 3;

EffectTerm termOf(const Effect& effect, Axis axis, const std::vector<double>& values) {
  EffectTerm term{std::string(effect.name()), {}};
  const auto specs = effect.parameters(axis);
  for (size_t k = 0; k < specs.size(); ++k) {
    const double value = std::clamp(values[k], specs[k].lower, specs[k].upper);
    term.parameters.push_back({specs[k].name, value, value, value});
  }
  return term;
}

std::vector<double> valuesOf(const EffectTerm& term) {
  std::vector<double> values;
  for (const Parameter& one : term.parameters) values.push_back(one.value);
  return values;
}

Model with(const SearchInput& input, const Model& model, const Pick& pick) {
  Model out = model;
  out.effects.push_back(termOf(*pick.effect, model.axis, pick.parameters));
  if (pick.track != everyTrack) out.effects.back().recording = fileNameOf(input.tracks[pick.track].name);
  return out;
}

/// Whether an effect, or every one of a model, is of a sign and size that it can have.
bool plausibleTerm(const EffectTerm& term, const Excitation& seen) {
  return findEffect(term.effect)->plausible(valuesOf(term), seen);
}
bool plausible(const Model& model, const Excitation& seen) {
  return std::all_of(model.effects.begin(), model.effects.end(),
                     [&seen](const EffectTerm& term) { return plausibleTerm(term, seen); });
}

Model without(const Model& model, const Effect& effect) {
  Model out = model;
  std::erase_if(out.effects, [&effect](const EffectTerm& term) { return term.effect == effect.name(); });
  return out;
}

bool same(const Effect* a, const Effect* b) {
  return a == b || (!a->twin().empty() && a->twin() == b->name());
}

/// Whether effects of the model carry hidden states, so that a fit has to simulate each parameter's change.
bool remembers(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [](const EffectTerm& term) { return findEffect(term.effect)->memory() > 0; });
}

ParameterVector vectorOf(const SearchInput& input, const Model& model) {
  return {model, input.held, std::max(input.seen.peakTorque, 1e-12), std::max(input.seen.highSpeed, 1e-9)};
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
    unit_ = result.base.weights;
    floor_ = noiseFloor(result.base.model, input_.tracks, input_.split.trainScore, input_.seed);
    result.best = result.base;
    say(0.2, "looking for what is missing");
    input_.seen.inertia = physicsInertia(result.base.model);
    const LinearRig rig(result.base.model, input_.tracks, input_.split.train);
    const Screen screen(rig, {catalogue().begin(), catalogue().end()}, input_.seen, input_.split.fold, folds,
                        input_.seed);
    const ScreenResult found = screen.run();
    if (input_.named) input_.named(important(found, result.base));
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    say(0.35, "simulating what was found");
    adopt(result, screen, found.chosen);
    for (const Pick& pick : result.chosen.empty() ? bestAlone(screen) : std::vector<Pick>{}) {
      if (result.chosen.empty()) adopt(result, screen, {pick});
    }
    backward(result);
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
  std::vector<double> validated(const FitResult& fit) const {
    return crossValidated(fit, vectorOf(input_, fit.model), input_.tracks, input_.split.train, input_.windowWeights,
                          input_.split.fold, folds, unit_);
  }
  FitResult fitFresh(const Model& start) const { return fitModel(input_, start, 6); }
  /// In long windows a wrong start of a wave is a valley away from the right one: short windows first.
  Model shortFit(const Model& start) const {
    return fitWindows(vectorOf(input_, start), input_.tracks, input_.split.trainScore,
                      {.iterations = 8, .tolerance = 1e-3, .windowWeights = {}, .stop = input_.stop})
        .model;
  }
  double chance(const std::vector<double>& before, const std::vector<double>& after) const {
    return std::min(1.0, static_cast<double>(catalogue().size()) * signFlipPValue(before, after, input_.seed));
  }

  /// The screen's effects whose part of the residual a simulation is likely to confirm.
  std::vector<Pick> important(const ScreenResult& found, const FitResult& base) const {
    std::vector<Pick> picks = found.chosen;
    const bool atFloor = mean(base.windowSquares) < materialFloors * materialFloors * floor_ * floor_;
    // At the position's floor a current may still show something, if that is most of what there is.
    const double least = (atFloor ? halfOfAll : importantPart) * found.baseSquares;
    std::erase_if(picks, [least](const Pick& one) { return one.gain < least; });
    return picks;
  }

  /// The model with the screen's base parameters, where they make sense.
  Model withBase(Model model, const Eigen::VectorXd& coefficients) const {
    const Physics physics = physicsOf(model);
    const MotorNames& names = motorNames(model.axis);
    const double hanging = model.pendulum ? pendulumInertia(*model.pendulum) : 0.0;
    const double emf = physics.electrical ? physics.torqueConstant * physics.backEmf / physics.resistance : 0.0;
    // The linear rig's back-EMF doesn't lag behind the inductance: J comes out smaller by that.
    const double late = physics.electrical ? physics.inductance / physics.resistance * emf : 0.0;
    // Where gravity is known, it tells the drive's scale.
    const double scale = physics.gravity > 0.0 ? std::hypot(coefficients[3], coefficients[4]) / physics.gravity : 1.0;
    const char* drive = physics.electrical ? names.resistance : names.torqueConstant;
    const double driveValue = physics.electrical ? physics.resistance * scale : physics.torqueConstant / scale;
    const std::array<std::pair<const char*, double>, 4> found{
        {{names.inertia, coefficients[0] / scale - hanging + late},
         {names.viscous, coefficients[1] / scale - emf / scale},
         {names.coulomb, coefficients[2] / scale},
         {drive, driveValue}}};
    for (const auto& [name, value] : found) {
      if (!(value > 0.0) || std::find(input_.held.begin(), input_.held.end(), name) != input_.held.end()) continue;
      for (Parameter& one : model.base) {
        if (one.name == name) one.value = value;
      }
    }
    return model;
  }
  Model withPicks(const SearchResult& result, const Screen& screen, const std::vector<Pick>& picks) const {
    Model model = withBase(result.base.model, screen.baseCoefficients(picks));
    for (const Pick& pick : picks) model = with(input_, model, pick);
    return model;
  }

  /// Whether the effect takes away error: of windows that a fit did not see, or, for what happens in few windows only,
  /// at least half of all.
  bool helps(const FitResult& without, const FitResult& with) const {
    if (!with.usable || !plausible(with.model, input_.seen)) return false;
    const Comparison gain = compare(validated(without), validated(with), input_.seed);
    const bool everywhere = gain.relative > leastImprovement && gain.interval.low > 0.0;
    return everywhere || gain.relative > clearImprovement ||
           mean(with.windowSquares) < 0.5 * mean(without.windowSquares);
  }

  /// Whether what the effect takes away would be missed beside what the sensors do.
  bool material(const FitResult& base, const FitResult& without, const FitResult& with) const {
    std::vector<double> gains(with.windowSquares.size());
    for (size_t k = 0; k < gains.size(); ++k) gains[k] = without.windowSquares[k] - with.windowSquares[k];
    const double back = mean(gains), unit = floor_ * floor_;
    std::sort(gains.begin(), gains.end());
    gains.resize(gains.size() - gains.size() / 10);
    // What few windows rule has to be larger: single windows err by more than sensors explain.
    const bool spread = mean(gains) > spreadFloors * unit || back > fewWindowsFloors * unit;
    const bool seen = mean(base.windowSquares) > materialFloors * materialFloors * unit;
    const bool position = seen && spread && back > leastFloors * unit && back > leastShare * mean(base.windowSquares);
    double noise = 0.0;
    for (const Track& track : input_.tracks) noise = std::max(noise, track.currentNoise);
    const double currentBack = without.currentSquares - with.currentSquares;
    return position ||
           (currentBack > clearOfCurrent * without.currentSquares && currentBack > leastFloors * noise * noise);
  }

  /// The screen's set as a whole, or else its most important members; where much is left, also with rivals in place.
  void adopt(SearchResult& result, const Screen& screen, std::vector<Pick> picks) const {
    for (; !picks.empty(); dropLeast(picks)) {
      FitResult fit = fitSet(result, screen, picks);
      if (mean(fit.windowSquares) > 4.0 * floor_ * floor_) {
        for (std::vector<Pick>& other : exchanged(screen, picks)) {
          FitResult rival = fitSet(result, screen, other);
          if (!rival.usable || mean(rival.windowSquares) > 0.7 * mean(fit.windowSquares)) continue;
          fit = std::move(rival);
          picks = std::move(other);
        }
      }
      if (!helps(result.base, fit)) {
        for (size_t k = 0; k < picks.size(); ++k) {
          if (!plausibleTerm(fit.model.effects[k], input_.seen)) picks[k].gain = 0.0;  // the first to go
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

  /// The effects that explain most alone.
  static std::vector<Pick> bestAlone(const Screen& screen) {
    std::vector<Pick> best;
    for (const Effect* effect : catalogue()) {
      Pick pick = screen.best(*effect, {});
      pick.pValue = largestPValue;
      if (!pick.parameters.empty()) best.push_back(std::move(pick));
    }
    std::stable_sort(best.begin(), best.end(), [](const Pick& a, const Pick& b) { return a.gain > b.gain; });
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

  FitResult fitSet(const SearchResult& result, const Screen& screen, const std::vector<Pick>& picks) const {
    const Model start = withPicks(result, screen, picks);
    FitResult fit = fitFresh(start);
    if (fit.usable && mean(fit.windowSquares) < 0.6 * mean(result.base.windowSquares)) return fit;
    std::vector<Model> starts = variantsOf(start);
    starts.push_back(shortFit(start));
    for (const Model& other : starts) {
      FitResult slow = fitFresh(other);
      if (slow.usable && mean(slow.windowSquares) < mean(fit.windowSquares)) fit = std::move(slow);
    }
    return fit;
  }

  /// What the screen could not see may still show in the simulation.
  bool tryMore(SearchResult& result, const Screen& screen, std::vector<Pick> picks) const {
    std::erase_if(picks, [&](const Pick& one) { return !contains(result, one.effect); });
    const auto before = validated(result.best);
    const double left = mean(result.best.windowSquares);
    if (left < 9.0 * floor_ * floor_ || left < 0.02 * mean(result.base.windowSquares)) return false;
    std::vector<Pick> candidates;
    for (const Effect* effect : catalogue()) {
      if (contains(result, effect)) continue;
      Pick pick = screen.best(*effect, picks);
      if (!pick.parameters.empty()) candidates.push_back(std::move(pick));
    }
    // What acts around standstill hardly shows in a regression.
    std::stable_sort(candidates.begin(), candidates.end(), [](const Pick& a, const Pick& b) {
      return (a.effect == &risingStiction() ? 1e300 : a.gain) > (b.effect == &risingStiction() ? 1e300 : b.gain);
    });
    std::optional<FitResult> winner;
    Chosen chosen;
    double best = 2.0 * surelyMore;
    const size_t most = remembers(result.best.model) ? 1 : mostTrials;  // hidden states are slow to fit
    for (size_t k = 0; k < std::min(most, candidates.size()); ++k) {
      const Model start = with(input_, result.best.model, candidates[k]);
      FitResult fit = fitFresh(start);
      if (!fit.usable || mean(fit.windowSquares) > (1.0 - clearImprovement) * left) fit = fitFresh(shortFit(start));
      if (!fit.usable || !plausible(fit.model, input_.seen)) continue;
      const auto after = validated(fit);
      const Comparison gain = compare(before, after, input_.seed);
      const double pValue = chance(before, after);
      if (!(gain.relative >= best) || gain.interval.low <= surelyMore || pValue > largestPValue) continue;
      best = gain.relative;
      winner = std::move(fit);
      chosen = {candidates[k].effect, pValue, 0.0, {}};
    }
    if (!winner) return false;
    result.best = std::move(*winner);
    result.chosen.push_back(chosen);
    return true;
  }

  static bool contains(const SearchResult& result, const Effect* effect) {
    return std::any_of(result.chosen.begin(), result.chosen.end(),
                       [effect](const Chosen& one) { return same(one.effect, effect); });
  }

  /// The model with one effect at a time at another variant.
  static std::vector<Model> variantsOf(const Model& model) {
    std::vector<Model> variants;
    for (size_t e = 0; e < model.effects.size(); ++e) {
      const Effect& effect = *findEffect(model.effects[e].effect);
      for (const auto& variant : effect.variants(valuesOf(model.effects[e]))) {
        variants.push_back(model);
        variants.back().effects[e] = termOf(effect, model.axis, variant);
        variants.back().effects[e].recording = model.effects[e].recording;
      }
    }
    return variants;
  }

  /// Held parameters are compared once everything else fits.
  void refine(SearchResult& result) const {
    if (remembers(result.best.model)) return;
    for (const Model& model : variantsOf(result.best.model)) {
      FitResult fit = fitModel(input_, model, 8);
      if (fit.usable && mean(fit.windowSquares) < mean(result.best.windowSquares)) result.best = std::move(fit);
    }
  }

  /// Whether the effect's amplitude, its first parameter, can't be told from zero.
  static bool vanishes(const Model& model, const Effect& effect) {
    for (const EffectTerm& term : model.effects) {
      if (term.effect == effect.name())
        return term.parameters.front().low95 < 0.0 && term.parameters.front().high95 > 0.0;
    }
    return true;
  }

  /// An effect that the others make superfluous goes; of those that stay, what they are worth.
  void backward(SearchResult& result) {
    left_.clear();
    for (bool changed = true; changed && !input_.stop.stop_requested();) {
      changed = false;
      left_.clear();
      for (size_t k = 0; k < result.chosen.size(); ++k) {
        FitResult fit = result.chosen.size() == 1
                            ? result.base
                            : fitModel(input_, without(result.best.model, *result.chosen[k].effect), 8);
        const double back = mean(fit.windowSquares) - mean(result.best.windowSquares);
        const bool needed = helps(fit, result.best) && material(result.base, fit, result.best);
        const bool clear = back > clearImprovement * mean(fit.windowSquares);
        if (needed && (clear || !vanishes(result.best.model, *result.chosen[k].effect))) {
          result.chosen[k].marginal = std::max(0.0, back);
          left_.push_back(std::move(fit));
          continue;
        }
        result.best = std::move(fit);
        result.chosen.erase(result.chosen.begin() + static_cast<std::ptrdiff_t>(k));
        changed = true;
        break;
      }
    }
  }

  /// The rivals of each chosen effect: others in its place.
  void weigh(SearchResult& result, const Screen& screen) {
    auto best = validated(result.best);
    for (size_t k = 0; k < result.chosen.size(); ++k) {
      if (input_.stop.stop_requested()) return;
      say(0.5 + 0.3 * static_cast<double>(k) / static_cast<double>(result.chosen.size()), "weighing rivals");
      std::vector<Pick> others, candidates;
      for (size_t j = 0; j < result.chosen.size(); ++j) {
        if (j != k) others.push_back(screen.best(*result.chosen[j].effect, others));
      }
      std::erase_if(others, [](const Pick& one) { return one.parameters.empty(); });
      const double own = screen.best(*result.chosen[k].effect, others).gain;
      for (const Effect* effect : catalogue()) {
        if (contains(result, effect)) continue;
        Pick pick = screen.best(*effect, others);
        const auto alike = result.chosen[k].effect->lookAlikes();
        const bool listed = std::find(alike.begin(), alike.end(), effect->name()) != alike.end();
        if (pick.parameters.empty() || pick.gain < (listed ? 0.7 : 0.8) * own) continue;
        candidates.push_back(std::move(pick));
      }
      std::stable_sort(candidates.begin(), candidates.end(),
                       [](const Pick& a, const Pick& b) { return a.gain > b.gain; });
      if (candidates.size() > mostRivals) candidates.resize(mostRivals);
      for (const Pick& one : candidates) {
        FitResult fit = fitFresh(with(input_, left_[k].model, one));
        if (!fit.usable || !plausible(fit.model, input_.seen)) continue;
        const auto errors = validated(fit);
        if (!std::isfinite(mean(errors))) continue;
        const Comparison ahead = compare(errors, best, input_.seed);
        if (ahead.inErrors < -2.0 && mean(errors) < 0.9 * mean(best)) {  // the rival is the better one
          if (compare(best, errors, input_.seed).inErrors < 2.0)
            result.chosen[k].rivals.push_back(result.chosen[k].effect);
          result.chosen[k].effect = one.effect;
          result.chosen[k].marginal = std::max(0.0, mean(left_[k].windowSquares) - mean(fit.windowSquares));
          result.chosen[k].rivals.clear();
          result.best = std::move(fit);
          best = errors;
          continue;
        }
        // Skewed errors hide a clear difference from the t-value: the sign-flip test sees it.
        const bool clearlyWorse = (ahead.relative > 0.25 && signFlipPValue(errors, best, input_.seed) <= 0.02) ||
                                  (ahead.relative > 0.5 && quantile(errors, 0.5) > 1.5 * quantile(best, 0.5));
        if (ahead.inErrors >= 2.0 || clearlyWorse) continue;
        // A push at a time of its own explains whatever happened then: physics that does as well is the better name.
        if (result.chosen[k].effect->happensOnce() && !one.effect->happensOnce()) {
          result.chosen[k].rivals.push_back(result.chosen[k].effect);
          result.chosen[k].effect = one.effect;
          result.best = std::move(fit);
          best = errors;
        } else {
          result.chosen[k].rivals.push_back(one.effect);
        }
      }
      if (const Effect* twin = findEffect(result.chosen[k].effect->twin())) result.chosen[k].rivals.push_back(twin);
    }
    std::stable_sort(result.chosen.begin(), result.chosen.end(),
                     [](const Chosen& a, const Chosen& b) { return a.marginal > b.marginal; });
  }

  SearchInput input_;
  double floor_ = 0.0;           ///< rms error of a perfect model
  Weights unit_;                 ///< of errors: what the base model leaves
  std::vector<FitResult> left_;  ///< without each chosen effect
};

}  // namespace

FitResult fitModel(const SearchInput& input, const Model& model, int iterations) {
  if (remembers(model)) iterations = std::min(iterations, 5);  // each takes several times as long
  return fitWindows(
      vectorOf(input, model), input.tracks, input.split.train,
      {.iterations = iterations, .tolerance = 1e-3, .windowWeights = input.windowWeights, .stop = input.stop});
}

FitResult fitBase(const SearchInput& input, const std::vector<Model>& starts) {
  FitResult best;
  for (const Model& start : starts) {
    FitResult fit = fitModel(input, start, 8);
    if (best.windows.empty() || (fit.usable && fit.rmse < best.rmse)) best = std::move(fit);
  }
  return best;
}

FitResult polishModel(const SearchInput& input, const Model& model, const std::vector<double>& windowWeights) {
  if (remembers(model)) return fitModel(input, model, 4);
  return fitWindows(vectorOf(input, model), input.tracks, input.split.polish,
                    {.iterations = 6, .exact = true, .windowWeights = windowWeights, .stop = input.stop});
}

Result<SearchResult> searchEffects(const SearchInput& input, const std::vector<Model>& starts) {
  return Search(input).run(starts);
}

Result<FitResult> fitNamed(const SearchInput& input, const std::vector<Model>& starts,
                           const std::vector<std::string>& names) {
  FitResult fit = fitModel(input, fitBase(input, starts).model);
  if (!names.empty()) {
    std::vector<const Effect*> effects;
    effects.reserve(names.size());
    for (const std::string& name : names) effects.push_back(findEffect(name));
    Model model = fit.model;
    std::vector<Pick> picks;
    const LinearRig rig(model, input.tracks, input.split.train);
    for (const Effect* effect : effects) {
      const Screen screen(rig, {effect}, input.seen, input.split.fold, folds, input.seed);
      picks.push_back(screen.best(*effect, picks));
      if (picks.back().parameters.empty()) {
        return Error{input.tracks.front().name, "can't show the effect " + std::string(effect->name()) + ": " +
                                                    effect->neededExcitation(input.seen)};
      }
      model = with(input, model, picks.back());
    }
    const ParameterVector parameters = vectorOf(input, model);
    const Model near = fitWindows(parameters, input.tracks, input.split.trainScore,
                                  {.iterations = 8, .tolerance = 1e-4, .windowWeights = {}, .stop = input.stop})
                           .model;
    fit = fitModel(input, near);
  }
  fit = polishModel(input, fit.model);
  if (!fit.usable)
    return Error{input.tracks.front().name, "can't be fitted: the search for the best parameters came to no end"};
  return fit;
}

}  // namespace breakaway
