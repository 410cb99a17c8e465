#include "diagnose/search/worth.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/cross_validation.h"

namespace breakaway {

namespace {

constexpr double leastImprovement = 0.03;
constexpr double clearOfCurrent = 0.35, muchOfCurrent = 0.25;  ///< of its squared error
constexpr double baseFloors = 1.6;   ///< a base model that errs by less lacks nothing that its position shows
constexpr double leastShare = 0.01;  ///< of the base model's squared error
constexpr double clearFloors = 9.0, hardlyAny = 0.1;  ///< of the squared floor, of a squared error
constexpr double spreadFloors = 0.3;
constexpr double fewWindowsFloors = 4.0;
constexpr double leastFloors = 0.8;  ///< of the squared floor
constexpr size_t mostKept = 8;       ///< validated errors

}  // namespace

Worth::Worth(const SearchInput& input, const FitResult& base, double restarts, double floor)
    : input_(input),
      unit_(base.weights),
      base_(mean(base.windowSquares)),
      baseCurrent_(base.currentSquares),
      restarts_(restarts),
      floor_(floor) {
}

std::vector<double> Worth::validated(const FitResult& fit) const {
  for (const Validated& one : known_) {
    if (one.effects == fit.model.effects && one.base == fit.model.base) return one.errors;
  }
  known_.push_front({fit.model.base, fit.model.effects,
                     crossValidated(fit, vectorOf(input_, fit.model), input_.tracks, input_.split.train,
                                    input_.windowWeights, input_.split.fold, folds, unit_)});
  if (known_.size() > mostKept) known_.pop_back();
  return known_.front().errors;
}

double Worth::chance(const std::vector<double>& before, const std::vector<double>& after) const {
  return std::min(1.0, static_cast<double>(catalogue().size()) * signFlipPValue(before, after, input_.seed));
}

bool Worth::helps(const FitResult& without, const FitResult& with) const {
  if (!with.usable || !plausible(with.model, input_.seen)) return false;
  const Comparison gain = compare(validated(without), validated(with), input_.seed);
  const bool everywhere = gain.relative > leastImprovement && gain.interval.low > 0.0;
  return everywhere || gain.relative > clearGain || mean(with.windowSquares) < 0.5 * mean(without.windowSquares);
}

bool Worth::material(const FitResult& without, const FitResult& with) const {
  std::vector<double> gains(with.windowSquares.size());
  for (size_t k = 0; k < gains.size(); ++k) gains[k] = without.windowSquares[k] - with.windowSquares[k];
  const double back = mean(gains), unit = floor_ * floor_;
  std::sort(gains.begin(), gains.end());
  gains.resize(gains.size() - gains.size() / 10);
  // If few windows make up the gain, it has to be larger: single windows err by more than sensors explain.
  const bool spread = mean(gains) > spreadFloors * unit || back > fewWindowsFloors * unit;
  // A fitted start takes up some of what a model lacks, and all that a restart's noise adds: restarts count, too.
  const bool seen = !baseAtFloor() || restarts_ > baseFloors * baseFloors * unit;
  // Beside a much larger effect an effect needs no share of the base's error if it takes nearly all away that is left.
  const bool clears = back > clearFloors * unit && mean(with.windowSquares) < hardlyAny * mean(without.windowSquares);
  const bool position = seen && spread && back > leastFloors * unit && (back > leastShare * base_ || clears);
  const double noise = currentNoise();
  const double currentBack = without.currentSquares - with.currentSquares;
  return position ||
         (currentBack > clearOfCurrent * without.currentSquares && currentBack > leastFloors * noise * noise);
}

double Worth::leastBack(bool inFew) const {
  const double unit = floor_ * floor_;
  const double unseen = std::max(0.0, baseFloors * baseFloors * unit - std::max(base_, restarts_));
  return std::max(
      {unseen, (inFew ? fewWindowsFloors : leastFloors) * unit, std::max(leastShare, leastImprovement) * base_});
}

std::optional<double> Worth::leastCurrentBack() const {
  if (!input_.seen.currentSeen) return {};
  // A part of what errs with the effect in it.
  return std::max(clearOfCurrent / (1.0 - clearOfCurrent) * baseCurrent_, leastFloors * std::pow(currentNoise(), 2));
}

double Worth::currentNoise() const {
  double noise = 0.0;
  for (const Track& track : input_.tracks) noise = std::max(noise, track.currentNoise);
  return noise;
}

bool Worth::currentErrs(const FitResult& fit) const {
  return input_.seen.currentSeen && fit.currentSquares > muchOfCurrent * baseCurrent_ &&
         fit.currentSquares > settledFloors * std::pow(currentNoise(), 2);
}

bool Worth::baseAtFloor() const {
  return base_ < baseFloors * baseFloors * floor_ * floor_;
}

double Worth::floors(const FitResult& fit) const {
  return mean(fit.windowSquares) / (floor_ * floor_);
}

}  // namespace breakaway
