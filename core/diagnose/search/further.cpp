#include "diagnose/search/further.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/cross_validation.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/search/window_slope.h"

namespace breakaway {

namespace {

constexpr size_t mostTrials = 4, fewTrials = 2, mostBySlope = 2;

bool holds(const Model& model, const Effect& effect) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [&effect](const EffectTerm& term) { return term.effect == effect.name(); });
}

}  // namespace

/// A start for friction that grows at rest, by simulation: a regression sees only the few rows of its breakaways, a
/// simulation sees all that follows from them.
Pick Further::simulatedBest(const Effect& effect, const Model& model, const Pick& screened) const {
  Pick best = screened;
  best.effect = &effect;
  const auto own = residualSquares(model, input_.tracks, input_.split.train);
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const std::vector<double>& parameters) {
    Pick other = best;
    other.parameters = parameters;
    if (parameters.empty() || !plausible(effect, parameters, input_.seen)) return;
    const auto squares = residualSquares(with(input_, model, other), input_.tracks, input_.split.train);
    const double left = typicalPart(squares, own, limits_.little);
    if (!(left < least)) return;
    least = left;
    best = std::move(other);
  };
  consider(std::vector(best.parameters));
  for (const Shape& shape : effect.shapes(input_.seen)) {
    for (const double part : {0.1, 0.3, 1.0}) {
      std::vector<double> parameters = shape.front();
      parameters.front() = part * input_.seen.coulomb;
      consider(parameters);
    }
  }
  return least < limits_.hardlyLess ? best : screened;
}

/// An effect that was found earlier may have stood for the one found now. If it is too small beside that, it is
/// dropped.
FitResult Further::withoutImplausible(FitResult fit) const {
  if (!fit.usable || plausible(fit.model, input_.seen)) return fit;
  Model model = fit.model;
  std::erase_if(model.effects, [this](const EffectTerm& term) { return !plausible(term, input_.seen); });
  return model.effects.empty() ? fit : fitModel(input_, model, 8);
}

/// The effects with the largest gain by the windows' slopes, which give sizes of their own. If a drive clips or the
/// base is far off, the regression is misled and may find no plausible size for an effect.
std::vector<Pick> Further::sloped(const SearchResult& result) const {
  std::vector<SlopePick> found;
  for (const Effect* effect : input_.effects) {
    if (contains(result.chosen, effect) && !effect->mayRepeat(input_.seen)) continue;
    SlopePick one = slopePick(input_, result.best, *effect);
    if (one.part > limits_.clearGain()) found.push_back(std::move(one));
  }
  std::stable_sort(found.begin(), found.end(), [](const SlopePick& a, const SlopePick& b) { return a.part > b.part; });
  // A push explains a part of whatever happened at its time, so it doesn't use up the places of other effects.
  size_t others = 0;
  std::erase_if(found,
                [&others](const SlopePick& one) { return !one.pick.effect->happensOnce() && others++ >= mostBySlope; });
  std::vector<Pick> picks;
  picks.reserve(found.size());
  for (SlopePick& one : found) picks.push_back(std::move(one.pick));
  return picks;
}

/// Whether a fit leaves hardly anything of another one's error, in the mean and typically. If few windows show an
/// effect, such as a drive's limit, folds can't foretell it.
bool Further::leavesNothing(const FitResult& without, const FitResult& with) const {
  if (swings(with.model) || happensOnce(with.model)) return false;
  const auto &before = without.windowSquares, &after = with.windowSquares;
  return mean(after) < limits_.hardlyAny * mean(before) && typicalPart(after, before, limits_.little) < limits_.half &&
         fits_.worth().chance(before, after) <= limits_.largestPValue;
}

/// If an effect has two ends, it may show only with both.
FitResult Further::withOtherEnd(FitResult fit, const Pick& one, double left) const {
  const Effect& effect = *one.effect;
  const bool ends = one.shape.size() == 1 && effect.mayRepeat(input_.seen) && !effect.happensOnce();
  if (!ends || !fit.usable || mean(fit.windowSquares) > limits_.clearlyLess * left) return fit;
  const SlopePick other = slopePick(input_, fit, effect);
  if (other.pick.parameters.empty()) return fit;
  FitResult both = fits_.fresh(with(input_, fit.model, other.pick));
  return both.usable && mean(both.windowSquares) < limits_.half * mean(fit.windowSquares) ? both : fit;
}

/// Whether a push takes much away; folds can't foretell what happens once.
bool Further::pushes(const SearchResult& before, const FitResult& fit, const Effect& effect) const {
  const EffectTerm& last = fit.model.effects.back();
  if (!effect.happensOnce() || last.effect != effect.name()) return false;
  const Parameter& size = last.parameters.front();
  const double part = mean(fit.windowSquares) / mean(before.best.windowSquares);
  return size.low95 * size.high95 > 0.0 &&
         part < (contains(before.chosen, &effect) ? limits_.clearlyLess : limits_.farLess);
}

bool Further::find(SearchResult& result, std::vector<Pick> picks) const {
  if (input_.enough()) return false;
  const Worth& worth = fits_.worth();
  std::erase_if(picks, [&](const Pick& one) { return !contains(result.chosen, one.effect); });
  const auto settled = [&] {
    const double left = mean(result.best.windowSquares);
    const double floors = worth.floors(result.best);
    if (worth.currentErrs(result.best)) return false;
    return floors < limits_.settled ||
           (floors < limits_.farOff && left < limits_.hardlyAny * mean(result.base.windowSquares));
  };
  if (settled()) return false;
  if (!remembers(result.best.model)) {  // far from the answer, a fit may have come to no end yet
    FitResult further = fitModel(input_, result.best.model, 8);
    if (further.usable && mean(further.windowSquares) < mean(result.best.windowSquares))
      result.best = std::move(further);
    if (settled()) return false;
  }
  const auto before = worth.validated(result.best);
  const double left = mean(result.best.windowSquares);
  std::vector<Pick> candidates;
  const bool loaded = swings(result.best.model);
  for (const Effect* effect : input_.effects) {
    if (contains(result.chosen, effect) && !effect->mayRepeat(input_.seen)) continue;
    Pick pick = screen_.best(*effect, picks);
    if (effect->growsAtRest()) pick = simulatedBest(*effect, result.best.model, pick);
    if (pick.parameters.empty()) continue;
    if (swings(pick) && (loaded || !adoption_.mayStillSwing(effect))) continue;
    candidates.push_back(std::move(pick));
  }
  sortByGain(candidates);
  // Effects around standstill hardly show in a regression: they come first. Loads take long: they come last. Beside
  // other effects one load is enough; if there is nothing else, all are tried, because a regression hardly tells them
  // apart.
  const auto loads =
      std::stable_partition(candidates.begin(), candidates.end(), [](const Pick& one) { return !swings(one); });
  std::stable_partition(candidates.begin(), loads, [](const Pick& one) { return one.effect->growsAtRest(); });
  const size_t most = remembers(result.best.model) ? fewTrials : mostTrials;  // hidden states are slow to fit
  if (loads != candidates.end() && !result.chosen.empty()) candidates.erase(loads + 1, candidates.end());
  const auto skipped =
      loads - candidates.begin() > static_cast<std::ptrdiff_t>(most) ? candidates.begin() + most : loads;
  candidates.erase(skipped, loads);
  // What pushed once may push again.
  std::stable_partition(candidates.begin(), candidates.end(), [&result](const Pick& one) {
    return one.effect->happensOnce() && contains(result.chosen, one.effect);
  });
  const std::vector<Pick> bySlope = sloped(result);
  candidates.insert(candidates.begin(), bySlope.begin(), bySlope.end());
  std::optional<FitResult> winner;
  Chosen chosen;
  double best = limits_.clearGain();
  for (const Pick& candidate : candidates) {
    if (input_.enough()) break;
    if (swings(candidate) && winner && worth.floors(*winner) < limits_.settled) break;
    std::vector<Pick> together = picks;
    together.push_back(candidate);
    FitResult fit = fits_.beside(result.best.model, screen_, together, left);
    fit = withOtherEnd(std::move(fit), candidate, left);
    fit = withoutImplausible(std::move(fit));
    if (!fit.usable || !plausible(fit.model, input_.seen) || !holds(fit.model, *candidate.effect)) continue;
    const auto after = worth.validated(fit);
    const Comparison gain = compare(before, after, input_.seed);
    const double pValue = worth.chance(before, after);
    if (swings(fit.model) && !fits_.helps(result.best, fit)) continue;
    const bool sure = gain.interval.low > limits_.sureGain && pValue <= limits_.largestPValue;
    const bool asFitted = fits_.breaksAwayBetter(result.best, fit) || leavesNothing(result.best, fit) ||
                          pushes(result, fit, *candidate.effect);
    const double part = asFitted ? 1.0 - mean(fit.windowSquares) / left : sure ? gain.relative : 0.0;
    if (!(part >= best)) continue;
    best = part;
    winner = std::move(fit);
    chosen = {candidate.effect, pValue, 0.0, {}};
  }
  if (!winner) return false;
  result.best = std::move(*winner);
  std::erase_if(result.chosen, [&](const Chosen& one) { return !holds(result.best.model, *one.effect); });
  if (!contains(result.chosen, chosen.effect)) result.chosen.push_back(chosen);
  return true;
}

}  // namespace breakaway
