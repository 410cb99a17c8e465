#include "diagnose/search.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/catalogue.h"
#include "diagnose/fit/inverse_proposals.h"

namespace breakaway {

namespace {

constexpr double largestPValue = 0.01;
constexpr double leastImprovement = 0.03;
constexpr double clearImprovement = 0.3;
constexpr double leastShare = 0.01;  ///< of the base model's squared error
constexpr size_t mostEffects = 5;
constexpr size_t finalists = 3;

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

Model with(const Model& model, const Candidate& candidate) {
  Model out = model;
  out.effects.push_back(
      termOf(*candidate.effect, model.axis, candidate.effect->fromAmplitudes(candidate.shape, candidate.amplitude)));
  return out;
}

Model without(const Model& model, const Effect& effect) {
  Model out = model;
  std::erase_if(out.effects, [&effect](const EffectTerm& term) { return term.effect == effect.name(); });
  return out;
}

/// Effects not in `model`, and of inseparable twins only the first.
std::vector<const Effect*> openEffects(const Model& model) {
  std::vector<const Effect*> open;
  for (const Effect* effect : catalogue()) {
    const auto present = [&model](std::string_view name) {
      return std::any_of(model.effects.begin(), model.effects.end(),
                         [name](const EffectTerm& term) { return term.effect == name; });
    };
    const bool twinListed =
        std::any_of(open.begin(), open.end(), [effect](const Effect* one) { return one->name() == effect->twin(); });
    if (!present(effect->name()) && !present(effect->twin()) && !twinListed) open.push_back(effect);
  }
  return open;
}

struct Comparison {
  double relative = 0.0;  ///< mean improvement over the mean of the worse
  Interval interval;      ///< 95 %, of `relative`
  double inErrors = 0.0;  ///< mean improvement in standard errors
};

/// How much smaller `after` is than `before`, window by window.
Comparison compare(const std::vector<double>& before, const std::vector<double>& after, std::uint64_t seed) {
  Comparison out;
  std::vector<double> gain(before.size());
  for (size_t k = 0; k < before.size(); ++k) gain[k] = before[k] - after[k];
  const double scale = std::max(mean(before), 1e-300), middle = mean(gain);
  double variance = 0.0;
  for (const double one : gain) variance += (one - middle) * (one - middle);
  const auto n = static_cast<double>(gain.size());
  const double error = std::sqrt(variance / std::max(1.0, n - 1.0) / n);
  out.relative = middle / scale;
  out.inErrors = error > 0.0 ? middle / error : 0.0;
  out.interval = bootstrap(gain.size(), 1000, seed, [&](std::span<const size_t> blocks) {
    double sumGain = 0.0, sumBefore = 0.0;
    for (const size_t block : blocks) {
      sumGain += gain[block];
      sumBefore += before[block];
    }
    return sumGain / std::max(sumBefore, 1e-300);
  });
  return out;
}

/// p-value of the windows' errors falling together: sign flips of the differences of their roots, one-sided.
double signFlipPValue(const std::vector<double>& before, const std::vector<double>& after, std::uint64_t seed) {
  std::vector<double> gain(before.size());
  for (size_t k = 0; k < before.size(); ++k) gain[k] = std::sqrt(before[k]) - std::sqrt(after[k]);
  const double seen = mean(gain);
  Random random(seed);
  size_t beaten = 0;
  constexpr size_t flips = 1999;
  for (size_t flip = 0; flip < flips; ++flip) {
    double sum = 0.0;
    for (const double one : gain) sum += random.bits() >> 63 ? one : -one;
    if (sum / static_cast<double>(gain.size()) >= seen) ++beaten;
  }
  return static_cast<double>(1 + beaten) / static_cast<double>(1 + flips);
}

class Search {
 public:
  explicit Search(SearchInput input) : input_(std::move(input)) {}

  Result<SearchResult> run(const std::vector<Model>& starts) {
    SearchResult result;
    say(0.05, "fitting the base model");
    result.base = fitBase(input_, starts);
    result.base = fitModel(input_, result.base.model, 10);
    input_.windowWeights = robustWeights(result.base.windowSquares);
    result.base = fitModel(input_, result.base.model, 10);
    result.best = result.base;
    if (auto done = forward(result); !done) return done.error();
    refine(result);
    backward(result);
    if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
    weigh(result);
    say(0.9, "refining");
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
  std::vector<double> validated(const FitResult& fit) const {
    return crossValidated(fit, vectorOf(fit.model), input_.tracks, input_.split.train, input_.windowWeights,
                          input_.split.fold, folds);
  }
  std::vector<Candidate> score(const FitResult& fit, const std::vector<const Effect*>& effects) const {
    const ParameterVector parameters = vectorOf(fit.model);
    return scoreTest(fit, parameters, input_.tracks, input_.split.train, effects, input_.seen, input_.seed,
                     input_.windowWeights);
  }
  ParameterVector vectorOf(const Model& model) const {
    return {model, input_.held, std::max(input_.seen.peakTorque, 1e-12), std::max(input_.seen.highSpeed, 1e-9)};
  }

  Result<void> forward(SearchResult& result) {
    for (size_t round = 0; round < mostEffects; ++round) {
      say(0.1 + 0.1 * static_cast<double>(round), "looking for a missing effect");
      if (input_.stop.stop_requested()) return Error{"diagnosis", "was cancelled"};
      const auto candidates = score(result.best, openEffects(result.best.model));
      const auto before = validated(result.best);
      std::optional<FitResult> winner;
      Chosen chosen;
      double best = leastImprovement;
      size_t tried = 0;
      for (const Candidate& candidate : candidates) {
        // The score is blind where a few windows rule it, or where the model without the effect is far off. Then an
        // effect may prove itself after the fit: one without a shape to choose, or one that improves more than any
        // choice of shape could by chance.
        const bool oneShape = candidate.effect->shapes(input_.seen).size() == 1;
        const double least = candidate.pValue > largestPValue ? 0.1 : leastImprovement;
        if (candidate.gain < least || tried == finalists) continue;
        ++tried;
        FitResult fit = fitModel(input_, with(result.best.model, candidate), 10);
        if (!fit.usable) continue;
        const auto after = validated(fit);
        double pValue = candidate.pValue;
        const Comparison gain = compare(before, after, input_.seed);
        if (oneShape || gain.relative > clearImprovement) {
          const double trials = static_cast<double>(candidates.size());
          pValue = std::min(pValue, std::min(1.0, trials * signFlipPValue(before, after, input_.seed)));
        }
        const bool material = mean(before) - mean(after) > leastShare * mean(validated(result.base));
        if (pValue > largestPValue || gain.interval.low <= 0.0 || gain.relative <= best || !material) continue;
        best = gain.relative;
        winner = std::move(fit);
        chosen = {candidate.effect, pValue, 0.0, {}};
      }
      if (!winner && !trySet(result, before)) return {};
      if (!winner) continue;
      result.best = std::move(*winner);
      result.chosen.push_back(chosen);
    }
    return {};
  }

  /// Effects that only help together: what the inverse model proposes replaces what was found so far if the windows
  /// clearly agree.
  bool trySet(SearchResult& result, const std::vector<double>& before) {
    if (triedSet_) return false;
    triedSet_ = true;
    const Model& base = result.base.model;
    const auto proposals = inverseProposals(base, input_.training, openEffects(base), input_.seen, 4);
    if (proposals.empty()) return false;
    Model first = base;
    for (const Proposal& one : proposals) first = with(first, {one.effect, one.shape, one.amplitude, 0.0, 1.0});
    std::vector<Model> starts{first};
    for (size_t e = 0; e < first.effects.size(); ++e) {
      for (const auto& variant : proposals[e].effect->variants(valuesOf(first.effects[e]))) {
        starts.push_back(first);
        starts.back().effects[e] = termOf(*proposals[e].effect, first.axis, variant);
      }
    }
    FitResult best;
    std::vector<double> after;
    for (const Model& start : starts) {
      FitResult fit = fitModel(input_, shortFit(start), 12);
      auto errors = validated(fit);
      if (!fit.usable || (!after.empty() && mean(errors) >= mean(after))) continue;
      best = std::move(fit);
      after = std::move(errors);
    }
    if (after.empty()) return false;
    const Comparison gain = compare(before, after, input_.seed);
    const double trials = static_cast<double>(openEffects(base).size());
    const double pValue = std::min(1.0, trials * signFlipPValue(before, after, input_.seed));
    if (gain.relative < clearImprovement || gain.interval.low <= 0.0 || pValue > largestPValue) return false;
    result.best = std::move(best);
    result.chosen.clear();
    for (const Proposal& one : proposals) result.chosen.push_back({one.effect, pValue, 0.0, {}});
    return true;
  }

  /// In long windows a wrong start of a wave is a valley away from the right one: short windows first.
  Model shortFit(const Model& start) const {
    return fitWindows(vectorOf(start), input_.tracks, input_.split.trainScore,
                      {.iterations = 12, .tolerance = 1e-4, .windowWeights = {}, .stop = input_.stop})
        .model;
  }

  /// Held parameters are compared once everything else fits.
  void refine(SearchResult& result) {
    for (const Chosen& chosen : result.chosen) {
      for (size_t e = 0; e < result.best.model.effects.size(); ++e) {
        if (result.best.model.effects[e].effect != chosen.effect->name()) continue;
        for (const auto& variant : chosen.effect->variants(valuesOf(result.best.model.effects[e]))) {
          Model model = result.best.model;
          model.effects[e] = termOf(*chosen.effect, model.axis, variant);
          FitResult fit = fitModel(input_, model, 12);
          if (fit.usable && mean(validated(fit)) < mean(validated(result.best))) result.best = std::move(fit);
        }
      }
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

  /// An effect that a later one has made superfluous goes.
  void backward(SearchResult& result) {
    bool changed = result.chosen.size() > 1;
    while (changed && !input_.stop.stop_requested()) {
      changed = false;
      for (size_t k = 0; k < result.chosen.size() && result.chosen.size() > 1; ++k) {
        FitResult fit = fitModel(input_, without(result.best.model, *result.chosen[k].effect), 10);
        const Comparison loss = compare(validated(fit), validated(result.best), input_.seed);
        const bool needed = loss.interval.low > 0.0 && loss.relative > leastImprovement;
        if (needed && !vanishes(result.best.model, *result.chosen[k].effect)) continue;
        result.best = std::move(fit);
        result.chosen.erase(result.chosen.begin() + static_cast<std::ptrdiff_t>(k));
        changed = true;
        break;
      }
    }
  }

  /// Importance and rivals of each chosen effect: the model without it, and others in its place.
  void weigh(SearchResult& result) {
    const auto best = validated(result.best);
    for (size_t k = 0; k < result.chosen.size(); ++k) {
      if (input_.stop.stop_requested()) return;
      Chosen& chosen = result.chosen[k];
      say(0.6 + 0.3 * static_cast<double>(k) / static_cast<double>(result.chosen.size()), "weighing rivals");
      const bool alone = result.chosen.size() == 1;
      const FitResult left = alone ? result.base : fitModel(input_, without(result.best.model, *chosen.effect), 10);
      chosen.marginal = std::max(0.0, mean(left.windowSquares) - mean(result.best.windowSquares));
      const auto candidates = score(left, openEffects(left.model));
      double own = 0.0;
      for (const Candidate& one : candidates) {
        if (same(one.effect, chosen.effect)) own = one.gain;
      }
      for (const Candidate& one : candidates) {
        if (same(one.effect, chosen.effect)) {
          if (!alone) chosen.pValue = std::min(chosen.pValue, one.pValue);
          continue;
        }
        if (one.gain < 0.5 * own) continue;
        const FitResult fit = fitModel(input_, with(left.model, one), 10);
        if (!fit.usable) continue;
        const Comparison ahead = compare(validated(fit), best, input_.seed);
        // Skewed errors hide a clear difference from the t-value: the sign-flip test sees it.
        const bool clearlyWorse = ahead.relative > 0.25 && signFlipPValue(validated(fit), best, input_.seed) <= 0.02;
        if (ahead.inErrors < 2.0 && !clearlyWorse) chosen.rivals.push_back(one.effect);
      }
      if (const Effect* twin = findEffect(chosen.effect->twin())) chosen.rivals.push_back(twin);
    }
    std::stable_sort(result.chosen.begin(), result.chosen.end(),
                     [](const Chosen& a, const Chosen& b) { return a.marginal > b.marginal; });
  }

  static bool same(const Effect* a, const Effect* b) { return a == b || a->twin() == b->name(); }

  SearchInput input_;
  bool triedSet_ = false;
};

}  // namespace

FitResult fitModel(const SearchInput& input, const Model& model, int iterations) {
  const ParameterVector parameters(model, input.held, std::max(input.seen.peakTorque, 1e-12),
                                   std::max(input.seen.highSpeed, 1e-9));
  return fitWindows(
      parameters, input.tracks, input.split.train,
      {.iterations = iterations, .tolerance = 1e-5, .windowWeights = input.windowWeights, .stop = input.stop});
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
  const ParameterVector parameters(model, input.held, std::max(input.seen.peakTorque, 1e-12),
                                   std::max(input.seen.highSpeed, 1e-9));
  return fitWindows(parameters, input.tracks, input.split.polish,
                    {.iterations = 6, .windowWeights = windowWeights, .stop = input.stop});
}

Result<SearchResult> searchEffects(const SearchInput& input, const std::vector<Model>& starts) {
  return Search(input).run(starts);
}

Result<FitResult> fitNamed(const SearchInput& input, const std::vector<Model>& starts,
                           const std::vector<std::string>& names) {
  FitResult fit = fitModel(input, fitBase(input, starts).model);
  for (const std::string& name : names) {
    const ParameterVector parameters(fit.model, input.held, std::max(input.seen.peakTorque, 1e-12),
                                     std::max(input.seen.highSpeed, 1e-9));
    const auto found =
        scoreTest(fit, parameters, input.tracks, input.split.train, {findEffect(name)}, input.seen, input.seed);
    if (found.empty()) {
      return Error{input.tracks.front().name,
                   "can't show the effect " + name + ": " + findEffect(name)->neededExcitation(input.seen)};
    }
    fit = fitModel(input, with(fit.model, found.front()));
  }
  fit = polishModel(input, fit.model);
  if (!fit.usable)
    return Error{input.tracks.front().name, "can't be fitted: the search for the best parameters came to no end"};
  return fit;
}

}  // namespace breakaway
