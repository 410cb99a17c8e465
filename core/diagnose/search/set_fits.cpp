#include "diagnose/search/set_fits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/statistics.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/simulator.h"

namespace breakaway {

SetFits::SetFits(const SearchInput& input, const FitResult& base)
    : input_(input),
      limits_(input.criteria),
      base_(base),
      restarts_(mean(scoreWindows(base.model, input.tracks, input.split.trainScore))),
      worth_(input, base, restarts_, noiseFloor(base.model, input.tracks, input.split.trainScore, input.seed)) {
}

SetFits::SetFits(const SetFits& other, const SearchInput& input, const FitResult& base)
    : input_(input),
      limits_(input.criteria),
      base_(base),
      restarts_(other.restarts_),
      worth_(other.worth_),
      loadsMayShow_(other.loadsMayShow_),
      expected_(other.expected_) {
}

void SetFits::weighRestarts(const TorqueNoise& left) {
  const double coulomb = physicsOf(base_.model).coulomb;
  if (left.rms > mostWander(coulomb, input_.seen.peakTorque, limits_)) {
    loadsMayShow_ = true;
    return;
  }
  const FrictionScatter scatter = usualScatter(input_.seen, coulomb, left, limits_);
  const double tolerated = noiseFloor(base_.model, input_.tracks, input_.split.trainScore, input_.seed, scatter);
  const double typical = typicalSquare(scoreWindows(base_.model, input_.tracks, input_.split.trainScore));
  loadsMayShow_ = typical > std::pow(limits_.nearFloor * tolerated, 2);
}

bool SetFits::helps(const FitResult& without, const FitResult& with) const {
  const bool loaded = swings(with.model) && !swings(without.model);
  if (loaded && !(with.usable && loadsAreTried() && clearlyBetterFromRestarts(with, without))) return false;
  return breaksAwayBetter(without, with) || worth_.helps(without, with);  // what takes long comes last
}

bool SetFits::breaksAwayBetter(const FitResult& without, const FitResult& with) const {
  if (!with.usable || !growsAtRest(with.model) || growsAtRest(without.model) || !plausible(with.model, input_.seen))
    return false;
  const auto &before = without.windowSquares, &after = with.windowSquares;
  return mean(after) < limits_.clearlyLess * mean(before) &&
         typicalPart(after, before, limits_.little) < limits_.clearlyLess &&
         worth_.chance(before, after) <= limits_.largestPValue;
}

bool SetFits::clearlyBetterFromRestarts(const FitResult& fit, const FitResult& other) const {
  const auto& windows = input_.split.trainScore;
  const auto now = scoreWindows(fit.model, input_.tracks, windows);
  double part = 0.0, ofAll = 0.0;
  const auto compareWith = [&](const Model& model) {
    const auto before = scoreWindows(model, input_.tracks, windows);
    // In single windows a load may run away although the model is right; in windows at rest it shows nothing.
    part = std::max(part, std::min(typicalPart(now, before, 0.0), typicalPart(now, before, limits_.little)));
    // A restart just after a breakaway may put a whole window off, whatever the model: the worst tenth is left out.
    ofAll = std::max(ofAll, typicalSquare(now) / std::max(typicalSquare(before), 1e-300));
  };
  compareWith(other.model);
  // With a load restarts look back further and so know the velocity better: the other model gets the same horizon.
  Model lookingBack = other.model;
  const Window& any = windows.front();
  lookingBack.restartHorizon_s = Simulator(fit.model, input_.tracks[any.track], any.first, any.last).horizon_s();
  if (lookingBack.restartHorizon_s > other.model.restartHorizon_s) compareWith(lookingBack);
  if (loadFollowsAll(fit, other, limits_)) return part < limits_.clearlyLess || ofAll < limits_.clearlyLess;
  if (loadsMayShow_ || !swings(fit.model) || swings(other.model))
    return part < limits_.clearlyLess || ofAll < limits_.half;
  return std::min(part, ofAll) < limits_.farLess;
}

FitResult SetFits::fresh(const Model& start) const {
  FitResult fit = fitModel(input_, start, 6);
  if (!fit.usable || !(happensOnce(start) || growsAtRest(start))) return fit;
  // It acts in the windows in which the base model errs most, and they count least for that reason: fitted once more
  // with other weights.
  const bool once = happensOnce(start);
  SearchInput own = input_;
  own.windowWeights =
      once ? std::vector<double>{} : robustWeights(residualSquares(start, input_.tracks, input_.split.train));
  FitResult again = fitModel(own, once ? fit.model : start, 6);
  return again.usable && mean(again.windowSquares) < mean(fit.windowSquares) ? again : fit;
}

FitResult SetFits::together(const Screen& screen, const std::vector<Pick>& picks) const {
  Model start = withScreenedBase(input_, base_.model, screen.baseCoefficients(picks));
  for (const Pick& pick : picks) start = with(input_, start, pick);
  FitResult fit = fresh(start);
  if (fit.usable && mean(fit.windowSquares) < limits_.half * mean(base_.windowSquares)) return fit;
  // Hidden states are slow to fit: several effects at once get one more start only.
  std::vector<Model> starts = picks.size() > 1 && remembers(start) ? std::vector<Model>{} : variantsOf(input_, start);
  starts.push_back(fitShort(input_, start));
  for (const Model& other : starts) {
    if (input_.enough()) break;
    FitResult slow = fresh(other);
    if (slow.usable && mean(slow.windowSquares) < mean(fit.windowSquares)) fit = std::move(slow);
  }
  return fit;
}

FitResult SetFits::beside(const Model& model, const Screen& screen, const std::vector<Pick>& picks, double left) const {
  const Pick& pick = picks.back();
  if (swings(pick)) return SwingingLoads(input_, worth_, model).fitted(pick);
  const Model start = with(input_, model, pick);
  FitResult fit = fresh(start);
  if (input_.enough() || (fit.usable && mean(fit.windowSquares) <= limits_.clearlyLess * left)) return fit;
  // A base model fitted without friction that grows at rest has too much friction in motion: start from the screen's.
  return fresh(pick.effect->growsAtRest() ? withScreenedBase(input_, start, screen.baseCoefficients(picks))
                                          : fitShort(input_, start));
}

}  // namespace breakaway
