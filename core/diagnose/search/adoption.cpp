#include "diagnose/search/adoption.h"

#include <algorithm>
#include <utility>

#include "base/statistics.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr size_t mostContinued = 4, mostWaves = 4;
constexpr size_t windowsToRank = 12;  ///< that tell at least what explains little
constexpr size_t mostThinned = 3;     ///< one window in so many, where there are more
constexpr size_t mostFitted = 6;      ///< more than are continued: a part may rank them otherwise

/// One in so many of the windows that a search fits.
class Part {
 public:
  Part(const Split& all, size_t oneIn) : oneIn_(std::max<size_t>(oneIn, 1)), split_(all) {
    split_.train = of(all.train);
    split_.fold = of(all.fold);
    split_.trainScore = of(all.trainScore);
  }
  const Split& split() const { return split_; }
  bool isAll() const { return oneIn_ == 1; }
  /// Of what is there for each window.
  template <typename T>
  std::vector<T> of(const std::vector<T>& each) const {
    std::vector<T> some;
    for (size_t k = 0; k < each.size(); k += oneIn_) some.push_back(each[k]);
    return some;
  }

 private:
  size_t oneIn_;
  Split split_;
};

void dropLeast(std::vector<Pick>& picks) {
  const auto nonsense = std::find_if(picks.begin(), picks.end(), [](const Pick& one) { return one.gain <= 0.0; });
  picks.erase(nonsense != picks.end() ? nonsense : picks.end() - 1);
}

/// First all further waves, which together take long to fit, and then one pick at a time.
void dropWavesOrLeast(std::vector<Pick>& picks) {
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

}  // namespace

const Screening* Adoption::adopt(SearchResult& result, const Screening& steady) {
  const auto& [screen, found] = steady;
  const Worth& worth = fits_.worth();
  double part = 0.0;
  bool named = false;
  for (const Pick& one : found.chosen) {
    part += one.gain;
    named = named || (swings(one) && one.gain > limits_.hardlyAny * found.baseSquares);
    if (swings(one) && one.gain > limits_.half * found.baseSquares) fits_.expectLoads();
  }
  const bool openToLoads = !worth.baseAtFloor() && (named || part <= limits_.half * found.baseSquares);
  SearchResult set = result;
  if (!named) adoptSet(set, screen, noteworthy(found, limits_));
  const Screening* again = lookAgain(set);
  const bool explained =
      again != nullptr && wanderBeside(wanderingRig_, picksOf(set.best.model, again->screen)).rms <=
                              mostWander(physicsOf(result.base.model).coulomb, input_.seen.peakTorque, limits_);
  if (openToLoads && !explained && mean(set.best.windowSquares) > limits_.farLess * mean(result.base.windowSquares)) {
    SearchResult loaded = result;
    adoptLoad(loaded, screen);
    // A load is free at each window's start: beside a set that explains much it has to do better from restarts, too.
    if (!loaded.chosen.empty() &&
        (set.chosen.empty() || again == nullptr || fits_.clearlyBetterFromRestarts(loaded.best, set.best))) {
      result = std::move(loaded);
      return nullptr;
    }
  }
  if (named && again == nullptr) adoptSet(set, screen, withOneLoad(found.chosen));
  result = std::move(set);
  return again;
}

void Adoption::adoptAlone(SearchResult& result, const Screen& screen) const {
  for (const Pick& pick : bestAlone(screen, limits_)) {
    if (!result.chosen.empty() || input_.enough()) return;
    adoptSet(result, screen, {pick});
    // An effect with two ends may fit only with both. Of waves the screen has already taken as many as it wants.
    if (!result.chosen.empty() || pick.shape.size() > 1 || !pick.effect->mayRepeat(input_.seen)) continue;
    Pick other = screen.best(*pick.effect, {pick});
    if (!other.parameters.empty()) adoptSet(result, screen, {pick, std::move(other)});
  }
}

/// An effect as the screen sizes it, or as it is at first.
Pick Adoption::pickOf(const Screen& screen, const Effect& effect) const {
  Pick pick = screen.best(effect, {});
  if (pick.parameters.empty()) {
    pick.effect = &effect;
    pick.shape = effect.shapes(input_.seen).front();
    pick.parameters = pick.shape.front();
  }
  return pick;
}

/// `effect` alone in a simulation, from the base model or from the screen's.
FitResult Adoption::alone(const FitResult& base, const Screen& screen, const Effect& effect) const {
  const double left = mean(base.windowSquares);
  const Pick pick = pickOf(screen, effect);
  FitResult fit = fits_.beside(base.model, screen, {pick}, left);
  if (fit.usable && mean(fit.windowSquares) <= limits_.farLess * left) return fit;
  FitResult other = fits_.together(screen, {pick});
  return other.usable && !(mean(fit.windowSquares) < mean(other.windowSquares)) ? other : fit;
}

/// Effects alone in a simulation, the one that leaves least first. Most explain little, which a part of the windows
/// tells from one start: only the best are fitted to all. What shows in a few windows only may be missing in that part.
std::vector<Adoption::Tried> Adoption::eachAlone(const FitResult& base, const Screen& screen) const {
  const Part part(input_.split, std::min(input_.split.train.size() / windowsToRank, mostThinned));
  const SearchInput partly(input_, part.split(), part.of(input_.windowWeights));
  FitResult partOfBase = base;
  partOfBase.windowSquares = part.of(base.windowSquares);
  const SetFits onPart(fits_, partly, partOfBase);
  const double leftOfPart = mean(partOfBase.windowSquares);
  std::vector<Tried> tried, sketched;
  for (const Effect* effect : screen.effects()) {
    if (input_.enough()) break;
    if (effect->shapes(input_.seen).empty() || effect->load() != nullptr) continue;
    const bool whole = part.isAll() || effect->happensOnce() || effect->growsAtRest();
    FitResult fit =
        whole ? alone(base, screen, *effect) : onPart.beside(base.model, screen, {pickOf(screen, *effect)}, leftOfPart);
    if (!fit.usable) continue;
    if (whole) {
      tried.push_back({effect, std::move(fit)});
    } else if (mean(fit.windowSquares) <= limits_.hardlyLess * leftOfPart) {
      sketched.push_back({effect, std::move(fit)});
    }
  }
  sortByLeft(sketched);
  if (sketched.size() > mostFitted) sketched.resize(mostFitted);
  for (Tried& one : sketched) {
    if (input_.enough()) break;
    one.fit = alone(base, screen, *one.effect);
    if (one.fit.usable) tried.push_back(std::move(one));
  }
  sortByLeft(tried);
  return tried;
}

void Adoption::sortByLeft(std::vector<Tried>& tried) {
  std::stable_sort(tried.begin(), tried.end(), [](const Tried& a, const Tried& b) {
    return mean(a.fit.windowSquares) < mean(b.fit.windowSquares);
  });
}

/// One wave of several may leave more than any other effect would: those that are likely beside it are added while each
/// leaves clearly less.
FitResult Adoption::withFurtherWaves(FitResult fit, const Effect& effect) const {
  for (bool more = true; more && !input_.enough();) {
    more = false;
    const std::vector<EffectTerm> terms = fit.model.effects;
    for (const EffectTerm& term : terms) {
      if (term.effect != effect.name() || terms.size() >= mostWaves) continue;
      for (std::vector<double>& wave : effect.besides(valuesOf(term), input_.seen)) {
        const double left = mean(fit.windowSquares);
        Pick pick;
        pick.effect = &effect;
        pick.parameters = std::move(wave);
        FitResult both = fits_.fresh(with(input_, fit.model, pick));
        if (!both.usable || !plausible(both.model, input_.seen) ||
            mean(both.windowSquares) > limits_.clearlyLess * left)
          continue;
        fit = std::move(both);
        more = true;
        break;
      }
      if (more) break;
    }
  }
  return fit;
}

void Adoption::addWaves(SearchResult& result) const {
  for (const Chosen& one : result.chosen) {
    if (fits_.worth().floors(result.best) <= limits_.settled || remembers(result.best.model)) return;
    result.best = withFurtherWaves(std::move(result.best), *one.effect);
  }
}

/// From far off a fit comes to its end late: it goes on while it leaves clearly less than before.
FitResult Adoption::toItsEnd(FitResult fit, double before) const {
  while (mean(fit.windowSquares) < limits_.clearlyLess * before && !input_.enough()) {
    before = mean(fit.windowSquares);
    FitResult further = fitModel(input_, fit.model, 10);
    if (further.usable && mean(further.windowSquares) < before) fit = std::move(further);
  }
  return fit;
}

/// Where the best effect alone leaves it far off, the best two of those tried that each take half of the base's error
/// away, if together they leave less than half of what the better one leaves: what two do alike, such as a gear's loss
/// and a drive's that both take from large torques, one of them may stand for.
std::optional<SearchResult> Adoption::bestTwo(const FitResult& base, const std::vector<Tried>& tried) const {
  if (tried.size() < 2 || remembers(tried.front().fit.model) ||
      fits_.worth().floors(tried.front().fit) <= limits_.farOff)
    return std::nullopt;
  std::optional<SearchResult> best;
  double least = limits_.half * mean(tried.front().fit.windowSquares);
  for (size_t one = 0; one < tried.size(); ++one) {
    for (size_t other = one + 1; other < tried.size(); ++other) {
      // A push does nothing like any other: it takes up what its own stretch errs by, whatever that is.
      const bool once = tried[one].effect->happensOnce() || tried[other].effect->happensOnce();
      if (once || mean(tried[other].fit.windowSquares) > limits_.half * mean(base.windowSquares)) continue;
      Model both = tried[one].fit.model;
      const auto& further = tried[other].fit.model.effects;
      both.effects.insert(both.effects.end(), further.begin(), further.end());
      if (remembers(both) || input_.enough()) continue;
      FitResult fit = toItsEnd(fits_.fresh(both), mean(tried[one].fit.windowSquares));
      if (!fit.usable || !plausible(fit.model, input_.seen) || mean(fit.windowSquares) >= least) continue;
      least = mean(fit.windowSquares);
      best.emplace();
      best->best = std::move(fit);
      for (const size_t k : {one, other}) best->chosen.push_back({tried[k].effect, limits_.largestPValue, 0.0, {}});
    }
  }
  return best && fits_.helps(base, best->best) ? best : std::nullopt;
}

void Adoption::adoptBest(SearchResult& result, const Screen& screen) const {
  const double left = mean(result.best.windowSquares);
  if (fits_.worth().floors(result.best) <= limits_.farOff) return;
  std::vector<Tried> tried = eachAlone(result.base, screen);
  if (tried.size() > mostContinued) tried.resize(mostContinued);
  for (Tried& one : tried)
    one.fit = withFurtherWaves(toItsEnd(std::move(one.fit), mean(result.base.windowSquares)), *one.effect);
  sortByLeft(tried);
  const std::optional<SearchResult> two = bestTwo(result.base, tried);
  std::erase_if(tried, [&](const Tried& one) {
    const double own = mean(one.fit.windowSquares);
    return own > limits_.half * mean(result.base.windowSquares) || own > limits_.clearlyLess * left ||
           !fits_.helps(result.base, one.fit);
  });
  if (two && mean(two->best.windowSquares) < limits_.half * left &&
      (tried.empty() || fits_.helps(tried.front().fit, two->best))) {
    result.best = two->best;
    result.chosen = two->chosen;
    return;
  }
  if (tried.empty()) return;
  Chosen chosen{tried.front().effect, limits_.largestPValue, 0.0, {}};
  for (size_t k = 1; k < tried.size(); ++k) {
    if (limits_.clearlyLess * mean(tried[k].fit.windowSquares) < mean(tried.front().fit.windowSquares))
      chosen.rivals.push_back(tried[k].effect);
  }
  result.best = std::move(tried.front().fit);
  result.chosen = {std::move(chosen)};
}

const Screening* Adoption::extend(SearchResult& result) {
  if (result.chosen.empty() || swings(result.best.model) || fits_.worth().floors(result.best) <= limits_.settled)
    return nullptr;
  const auto& [screening, other] = wandering(result);
  const bool goesOn = contains(other.chosen, result.chosen.front().effect);
  if (!goesOn || mean(other.best.windowSquares) >= limits_.clearlyLess * mean(result.best.windowSquares))
    return nullptr;
  result = other;
  return &screening;
}

bool Adoption::mayStillSwing(const Effect* load) const {
  return fits_.loadsMayShow() && (!loadsTried_ || isLikely(load));
}

void Adoption::listOtherLoads(SearchResult& result) const {
  for (Chosen& one : result.chosen) {
    if (!isLikely(one.effect)) continue;
    for (const InPlace& other : likelyLoads_) {
      if (other.effect == one.effect) continue;
      const bool listed = std::find(one.rivals.begin(), one.rivals.end(), other.effect) != one.rivals.end();
      if (!listed) one.rivals.push_back(other.effect);
      const bool tried = std::any_of(one.tried.begin(), one.tried.end(),
                                     [&other](const InPlace& known) { return known.effect == other.effect; });
      if (!tried) one.tried.push_back(other);
    }
  }
}

/// The picks as a whole, or else the most important of them; where much is left, also with rivals in place, or the most
/// important one alone.
void Adoption::adoptSet(SearchResult& result, const Screen& screen, std::vector<Pick> picks) const {
  while (!picks.empty() && !input_.enough()) {
    FitResult fit = fits_.together(screen, picks);
    if (fits_.worth().floors(fit) > limits_.nearFloor) {
      std::vector<std::vector<Pick>> others = exchanged(screen, picks);
      if (picks.size() > 1) others.push_back({picks.front()});  // the others may have led the fit astray
      for (std::vector<Pick>& other : others) {
        FitResult rival = fits_.together(screen, other);
        if (!rival.usable || mean(rival.windowSquares) > limits_.clearlyLess * mean(fit.windowSquares)) continue;
        fit = std::move(rival);
        picks = std::move(other);
      }
    }
    if (!fits_.helps(result.base, fit)) {
      for (size_t k = 0; k < picks.size(); ++k) {
        if (!plausible(fit.model.effects[k], input_.seen)) picks[k].gain = 0.0;  // the first to go
      }
      // If a set explains nearly all and only one wave or end is implausible, the others stay.
      const auto nonsense = std::find_if(picks.begin(), picks.end(), [](const Pick& one) { return one.gain <= 0.0; });
      if (nonsense != picks.end() && mean(fit.windowSquares) < limits_.farLess * mean(result.base.windowSquares)) {
        picks.erase(nonsense);
      } else {
        dropWavesOrLeast(picks);
      }
      continue;
    }
    result.best = std::move(fit);
    for (const Pick& pick : asEffects(picks)) result.chosen.push_back({pick.effect, pick.pValue, 0.0, {}});
    return;
  }
}

void Adoption::adoptLoad(SearchResult& result, const Screen& screen) {
  loadsTried_ = true;
  if (!fits_.loadsAreTried()) return;
  std::vector<InPlace> left;
  const SwingingLoads loads(input_, fits_.worth(), result.base.model);
  for (const Pick& pick : SwingingLoads::offered(input_, screen)) {
    if (input_.enough()) break;
    FitResult fit = loads.fitted(pick);
    if (!fit.usable || !fits_.helps(result.base, fit)) continue;
    const double own = mean(fit.windowSquares);
    left.push_back({pick.effect, fit.model, own});
    if (own >= mean(result.best.windowSquares)) continue;
    result.best = std::move(fit);
    result.chosen = {{pick.effect, limits_.largestPValue, 0.0, {}}};
  }
  for (InPlace& one : left) {
    if (limits_.farLess * one.square < mean(result.best.windowSquares)) likelyLoads_.push_back(std::move(one));
  }
}

/// Where a set leaves much, what the screen finds if the torque wanders, in its place; null if that is no better.
const Screening* Adoption::lookAgain(SearchResult& set) {
  const double left = mean(set.best.windowSquares);
  if (fits_.worth().baseAtFloor() || fits_.worth().floors(set.best) <= limits_.settled ||
      left <= limits_.half * mean(set.base.windowSquares))
    return nullptr;
  const auto& [screening, other] = wandering(set);
  const bool current = other.best.currentSquares < limits_.clearlyLess * set.best.currentSquares;
  if (mean(other.best.windowSquares) >= (current ? 1.0 : limits_.clearlyLess) * left) return nullptr;
  set = other;
  return &screening;
}

const Adoption::Wandering& Adoption::wandering(const SearchResult& base) {
  if (!wandering_) {
    wandering_.emplace(Wandering{Screening(input_, wanderingRig_, withoutLoads(input_)), base});
    SearchResult& set = wandering_->set;
    set.best = set.base;
    set.chosen.clear();
    adoptSet(set, wandering_->screening.screen, noteworthy(wandering_->screening.found, limits_));
  }
  return *wandering_;
}

bool Adoption::isLikely(const Effect* load) const {
  return std::any_of(likelyLoads_.begin(), likelyLoads_.end(),
                     [load](const InPlace& one) { return one.effect == load; });
}

}  // namespace breakaway
