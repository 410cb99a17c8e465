#include "diagnose/search/screening.h"

#include <algorithm>
#include <utility>

#include "diagnose/effects/catalogue.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/search/worth.h"

namespace breakaway {

namespace {

constexpr size_t mostAlone = 4;

}  // namespace

std::vector<const Effect*> withoutLoads(const SearchInput& input) {
  std::vector<const Effect*> effects = input.effects;
  std::erase_if(effects, [&input](const Effect* one) {
    const auto shapes = one->shapes(input.seen);
    return !shapes.empty() && one->load() != nullptr;
  });
  return effects;
}

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

std::vector<Pick> noteworthy(const ScreenResult& found, const Criteria& criteria) {
  std::vector<Pick> picks = found.chosen;
  const double least = criteria.negligible * found.baseSquares;
  std::vector<Pick> effects = asEffects(picks);
  std::erase_if(effects, [least](const Pick& one) { return one.gain < least; });
  std::erase_if(picks, [&](const Pick& one) { return swings(one) || !contains(effects, one.effect); });
  return picks;
}

std::vector<Pick> withOneLoad(std::vector<Pick> picks) {
  bool loaded = false;
  std::erase_if(picks, [&loaded](const Pick& one) {
    if (one.effect->load() == nullptr) return false;
    return std::exchange(loaded, true);
  });
  return picks;
}

std::vector<Pick> bestAlone(const Screen& screen, const Criteria& criteria) {
  std::vector<Pick> best;
  for (const Effect* effect : screen.effects()) {
    Pick pick = screen.best(*effect, {});
    pick.pValue = criteria.largestPValue;
    if (!pick.parameters.empty()) best.push_back(std::move(pick));
  }
  sortByGain(best);
  const double least = best.empty() ? 0.0 : criteria.half * best.front().gain;
  std::erase_if(best, [least](const Pick& one) { return one.gain < least; });
  if (best.size() > mostAlone) best.resize(mostAlone);
  return best;
}

std::vector<std::vector<Pick>> exchanged(const Screen& screen, const std::vector<Pick>& picks) {
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

std::vector<Pick> picksOf(const Model& model, const Screen& screen) {
  std::vector<Pick> picks;
  for (const EffectTerm& term : model.effects) {
    Pick pick = screen.best(*findEffect(term.effect), picks);
    if (!pick.parameters.empty()) picks.push_back(std::move(pick));
  }
  return picks;
}

TorqueNoise wanderBeside(const LinearRig& wandering, const std::vector<Pick>& picks) {
  Eigen::MatrixXd more(wandering.response().size(), 0);
  for (const Pick& pick : picks) {
    const Eigen::MatrixXd own = wandering.rawColumnsOf(*pick.effect, pick.shape, pick.track);
    more.conservativeResize(Eigen::NoChange, more.cols() + own.cols());
    more.rightCols(own.cols()) = own;
  }
  return wandering.wander(more);
}

}  // namespace breakaway
