#include "diagnose/search/rivals.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/cross_validation.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/search/voltage_balance.h"

namespace breakaway {

namespace {

constexpr size_t mostRivals = 3;

constexpr double roundFigure = 0.05;  ///< to which a rig and its model agree

size_t wavesOf(const Model& model, const Effect& effect) {
  return static_cast<size_t>(std::count_if(model.effects.begin(), model.effects.end(),
                                           [&effect](const EffectTerm& term) { return term.effect == effect.name(); }));
}

/// How many of the effect's numbers a fit may change.
size_t freedomOf(const Model& model, const Effect& effect) {
  const auto specs = effect.parameters(model.axis);
  const auto free =
      std::count_if(specs.begin(), specs.end(), [](const ParameterSpec& one) { return !one.held || one.freeInTheEnd; });
  return wavesOf(model, effect) * static_cast<size_t>(free);
}

bool lists(const Chosen& chosen, const Effect* rival) {
  return std::find(chosen.rivals.begin(), chosen.rivals.end(), rival) != chosen.rivals.end();
}

/// Another effect in the place of the k-th chosen one, which has been tried then.
void takePlace(SearchResult& result, size_t k, const Effect& other, FitResult fit) {
  Chosen& chosen = result.chosen[k];
  chosen.keepTried(chosen.effect, result.best);
  std::erase_if(chosen.tried, [&other](const InPlace& one) { return one.effect == &other; });
  chosen.effect = &other;
  result.best = std::move(fit);
}

}  // namespace

/// Adds the effect's best shape beside the others, if it has any.
void Rivals::addBest(const Effect& effect, std::vector<Pick>& others) const {
  Pick pick = screen_.best(effect, others);
  if (!pick.parameters.empty()) others.push_back(std::move(pick));
}

/// What the screen makes of all terms but those of the k-th chosen effect.
std::vector<Pick> Rivals::othersOf(const SearchResult& result, size_t k) const {
  std::vector<Pick> others;
  for (const EffectTerm& term : result.best.model.effects) {
    const Effect* effect = findEffect(term.effect);
    if (effect != result.chosen[k].effect) addBest(*effect, others);
  }
  return others;
}

/// Effects that the screen finds nearly as good as the chosen one, beside the other chosen ones.
std::vector<Pick> Rivals::nearlyAsGood(const SearchResult& result, size_t k) const {
  std::vector<Pick> candidates;
  const std::vector<Pick> others = othersOf(result, k);
  const double own = screen_.best(*result.chosen[k].effect, others).gain;
  const auto alike = result.chosen[k].effect->lookAlikes();
  const auto listed = [&alike](const Effect* effect) {
    return std::find(alike.begin(), alike.end(), effect->name()) != alike.end();
  };
  for (const Effect* effect : input_.effects) {
    if (contains(result.chosen, effect)) continue;
    Pick pick = screen_.best(*effect, others);
    if (pick.parameters.empty() || pick.gain < limits_.clearlyLess * own) continue;
    candidates.push_back(std::move(pick));
  }
  sortByGain(candidates);
  if (candidates.size() <= mostRivals) return candidates;
  // If all that are left are no look-alikes, the best look-alike is tried, too, although others gain more on the
  // screen.
  const auto rest = candidates.begin() + mostRivals;
  const auto alikeToo = std::find_if(rest, candidates.end(), [&](const Pick& one) { return listed(one.effect); });
  const bool seen = std::any_of(candidates.begin(), rest, [&](const Pick& one) { return listed(one.effect); });
  const bool more = !seen && alikeToo != candidates.end();
  if (more) std::iter_swap(rest, alikeToo);
  candidates.resize(mostRivals + (more ? 1 : 0));
  return candidates;
}

/// Look-alikes of the chosen effect, either way, that are tried whatever the regression says (Effect::asRival()).
std::vector<Pick> Rivals::whateverTheScreen(const SearchResult& result, size_t k) const {
  std::vector<Pick> picks;
  const Effect& chosen = *result.chosen[k].effect;
  const auto names = [](const Effect& one, const Effect& other) {
    const auto alike = one.lookAlikes();
    return std::find(alike.begin(), alike.end(), other.name()) != alike.end();
  };
  for (const Effect* effect : input_.effects) {
    if (contains(result.chosen, effect) || !(names(chosen, *effect) || names(*effect, chosen))) continue;
    for (const auto& parameters : effect->asRival(input_.seen)) {
      picks.emplace_back();
      picks.back().effect = effect;
      picks.back().shape = {parameters};
      picks.back().parameters = parameters;
    }
  }
  return picks;
}

/// Whether there is no time to try it: then it is a rival, for all that is known.
bool Rivals::listUntried(SearchResult& result, Chosen& chosen, const Effect* rival) const {
  if (!input_.enoughWeighed()) return false;
  result.unweighed = true;
  if (!lists(chosen, rival)) chosen.rivals.push_back(rival);
  return true;
}

/// Tries a rival in the place of a chosen effect, without which `left` remains; `best` are the validated errors of the
/// best model.
void Rivals::tryInPlace(SearchResult& result, size_t k, const FitResult& left, const Pick& rival,
                        std::vector<double>& best) const {
  Chosen& chosen = result.chosen[k];
  // Short windows, which found the chosen load, tell two loads apart better than long ones: no exchange here.
  const bool exchange = swings(result.best.model) && !swings(left.model);
  if (swings(rival) && (exchange || !fits_.loadsMayShow())) return;
  if (listUntried(result, chosen, rival.effect)) return;
  // If the chosen effect has several waves, the rival may have as many.
  const size_t waves = wavesOf(result.best.model, *chosen.effect);
  Model start = with(input_, left.model, rival);
  for (std::vector<Pick> picks = othersOf(result, k); wavesOf(start, *rival.effect) < waves;) {
    if (picks.empty() || !same(picks.back().effect, rival.effect)) picks.push_back(rival);
    if (!rival.effect->mayRepeat(input_.seen)) break;
    const size_t before = picks.size();
    addBest(*rival.effect, picks);
    if (picks.size() == before) break;
    start = with(input_, start, picks.back());
  }
  FitResult fit = fits_.fresh(start);
  const bool unscreened = rival.gain <= 0.0;  // its size is no more than a guess
  if (unscreened && fit.usable) fit = fitModel(input_, fit.model, 10);
  if (!fit.usable || !possible(fit.model, input_.seen)) return;
  const auto errors = fits_.worth().validated(fit);
  if (!std::isfinite(mean(errors))) return;
  chosen.keepTried(rival.effect, fit);
  const Comparison ahead = compare(errors, best, input_.seed);
  // If errors are skewed, the t-value misses a clear difference; the sign-flip test sees it.
  const bool clearlyWorse =
      (ahead.relative > limits_.clearGain() &&
       signFlipPValue(errors, best, input_.seed) <= limits_.likeliestByChance) ||
      (ahead.relative > limits_.half && quantile(errors, 0.5) > limits_.clearlyMore() * quantile(best, 0.5));
  const bool freer = swings(fit.model) && !swings(result.best.model);
  // If a form isn't quite right, folds mislead: halving the error of all windows counts as clearly better, too.
  const bool clearlyBetter =
      ahead.inErrors < -limits_.apart || (mean(fit.windowSquares) < limits_.half * mean(result.best.windowSquares) &&
                                          quantile(errors, 0.5) < limits_.hardlyLess * quantile(best, 0.5));
  // If the rival's size may be zero and the chosen one's isn't, the rival borrows from friction: no better name.
  const bool vaguer = vanishes(fit.model, *rival.effect) && !vanishes(result.best.model, *chosen.effect);
  const size_t freedom = freedomOf(fit.model, *rival.effect), own = freedomOf(result.best.model, *chosen.effect);
  // If the rival has more free numbers and still leaves more error, it is no better name, whatever the folds say.
  const double leaves = mean(fit.windowSquares) / mean(result.best.windowSquares);
  const bool better = clearlyBetter && !vaguer && mean(errors) < limits_.hardlyLess * mean(best) &&
                      leaves < (freedom > own ? 1.0 : limits_.clearlyMore()) &&
                      (!freer || fits_.clearlyBetterFromRestarts(fit, result.best));
  const bool simpler = freedom < own && leaves < limits_.hardlyMore();
  // If the chosen effect stands, something is there: a rival that does better may be of any size.
  if (!better && !plausible(fit.model, input_.seen)) return;
  const bool leavesFarMore = leaves > limits_.farMore() && typicalPart(fit.windowSquares, result.best.windowSquares,
                                                                       limits_.little) > 1.0 / limits_.half;
  if (!better && !simpler && (ahead.inErrors >= limits_.apart || clearlyWorse || leavesFarMore)) return;
  // A push at a time of its own explains whatever happened then: if physics does as well, it is the better name. Folds
  // can't foretell a push and so favour its rivals: one that leaves much more error is dropped.
  const bool push = chosen.effect->happensOnce() && !rival.effect->happensOnce();
  if (!better && push && leaves > limits_.clearlyMore()) return;
  // If the chosen size may be zero and the rival does as well with fewer free numbers, the rival takes its place.
  const bool firmer = simpler &&
                      (vanishes(result.best.model, *chosen.effect) || (unscreened && leaves < limits_.clearlyLess)) &&
                      !vanishes(fit.model, *rival.effect);
  if (!better && !push && !firmer) {
    if (!lists(chosen, rival.effect)) chosen.rivals.push_back(rival.effect);  // of several shapes one may be listed
    return;
  }
  if (result.chosen.size() == 1) result.displaced.emplace_back(chosen, result.best);
  if (better) {
    chosen.marginal = std::max(0.0, mean(left.windowSquares) - mean(fit.windowSquares));
    chosen.rivals.clear();
  } else {
    std::erase(chosen.rivals, rival.effect);
    chosen.rivals.push_back(chosen.effect);
  }
  takePlace(result, k, *rival.effect, std::move(fit));
  best = errors;
}

/// Among several findings a name may depend on how the others were chosen: if a look-alike does as well alone, it is a
/// rival.
void Rivals::weighAlone(SearchResult& result) const {
  Chosen& first = result.chosen.front();
  const auto aloneWith = [&](const Pick& pick) {
    return pick.parameters.empty() ? FitResult{} : fits_.together(screen_, {pick});
  };
  const Pick ownPick = screen_.best(*first.effect, {});
  std::optional<double> own;  // squared error; the fits themselves are large
  for (const std::string_view name : first.effect->lookAlikes()) {
    const Effect* alike = findEffect(name);
    if (lists(first, alike) || contains(result.chosen, alike) || alike->hidden() != nullptr) continue;
    const Pick pick = screen_.best(*alike, {});
    if (pick.gain < limits_.half * ownPick.gain || listUntried(result, first, alike)) continue;
    if (!own) {
      const FitResult fit = aloneWith(ownPick);
      if (!fit.usable || !fits_.worth().helps(result.base, fit)) return;
      own = mean(fit.windowSquares);
    }
    const FitResult rival = aloneWith(pick);
    if (!rival.usable || !plausible(rival.model, input_.seen)) continue;
    // Both are single effects, so that their errors can be compared as they are.
    if (mean(rival.windowSquares) > *own) continue;
    first.rivals.push_back(alike);
    first.keepTried(alike, rival);
  }
}

/// Where current drives, its sensor may show what isn't there, and that is the chosen effect for the motion. A voltage
/// that was recorded, too, tells: it knows the sensor's offset and nothing of the motion's torque.
void Rivals::askVoltage(SearchResult& result, size_t k) const {
  if (!input_.seen.currentDrive) return;
  for (const Effect* effect : input_.effects) {
    const CurrentSensorPart* sensor = effect->currentSensor();
    const Effect* alike = sensor != nullptr ? findEffect(sensor->sameForMotion()) : nullptr;
    if (alike != nullptr && same(result.chosen[k].effect, alike)) askVoltage(result, k, *effect);
  }
}

void Rivals::askVoltage(SearchResult& result, size_t k, const Effect& offset) const {
  Chosen& chosen = result.chosen[k];
  if (contains(result.chosen, &offset)) return;
  const auto shown = sensorOffset(input_.tracks, input_.split.train);
  if (!shown) return;
  Pick pick;
  pick.effect = &offset;
  pick.parameters = {shown->value_A};
  const Model others = without(result.best.model, *chosen.effect);
  FitResult fit = fitModel(input_, with(input_, others, pick), 10);
  if (!fit.usable || !plausible(fit.model, input_.seen)) return;
  const double leaves = mean(fit.windowSquares) / mean(result.best.windowSquares);
  const Parameter& needed = fit.model.effects.back().parameters.front();  // by the motion
  const double deviation =
      std::hypot(shown->deviation_A, (needed.high95 - needed.low95) / 3.92, roundFigure * needed.value);
  const double apart = std::abs(shown->value_A - needed.value) / deviation;
  const bool there = std::abs(shown->value_A) > limits_.farApart * shown->deviation_A;
  if (leaves > limits_.hardlyMore() ||
      (apart > limits_.farApart && !(there && shown->value_A / needed.value > limits_.half)))
    return;
  if (there && apart <= limits_.farApart) {
    chosen.rivals.clear();
    takePlace(result, k, offset, std::move(fit));
  } else {
    chosen.keepTried(&offset, fit);
    if (!lists(chosen, &offset)) chosen.rivals.push_back(&offset);
  }
}

void Rivals::weigh(SearchResult& result, std::vector<FitResult> left) const {
  auto best = fits_.worth().validated(result.best);
  for (size_t k = 0; k < result.chosen.size(); ++k) {
    if (input_.stop.stop_requested()) return;
    input_.say(0.5 + 0.3 * static_cast<double>(k) / static_cast<double>(result.chosen.size()),
               message("weighing rivals"));
    for (const Pick& rival : nearlyAsGood(result, k)) tryInPlace(result, k, left[k], rival, best);
    for (const Pick& rival : whateverTheScreen(result, k)) tryInPlace(result, k, left[k], rival, best);
    askVoltage(result, k);
    if (const Effect* twin = findEffect(result.chosen[k].effect->twin())) result.chosen[k].rivals.push_back(twin);
  }
  std::stable_sort(result.chosen.begin(), result.chosen.end(),
                   [](const Chosen& a, const Chosen& b) { return a.marginal > b.marginal; });
  left.clear();  // the fits are large, and no longer needed
  if (result.chosen.size() > 1) weighAlone(result);
}

}  // namespace breakaway
