#include "diagnose/search/worth.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/cross_validation.h"

namespace breakaway {

namespace {

constexpr size_t mostKept = 8;  ///< validated errors

}  // namespace

Worth::Worth(const SearchInput& input, const FitResult& base, double restarts, double floor)
    : input_(input),
      limits_(input.criteria),
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
  known_.push_front(
      {fit.model.base, fit.model.effects,
       crossValidated(fit, input_.tracks, input_.split.train, input_.windowWeights, input_.split.fold, folds, unit_)});
  if (known_.size() > mostKept) known_.pop_back();
  return known_.front().errors;
}

double Worth::chance(const std::vector<double>& before, const std::vector<double>& after) const {
  return std::min(1.0, static_cast<double>(catalogue().size()) * signFlipPValue(before, after, input_.seed));
}

bool Worth::helps(const FitResult& without, const FitResult& with) const {
  if (!with.usable || !plausible(with.model, input_.seen)) return false;
  const Comparison gain = compare(validated(without), validated(with), input_.seed);
  const bool everywhere = gain.relative > limits_.hardlyAny && gain.interval.low > 0.0;
  return everywhere || gain.relative > limits_.clearGain() ||
         mean(with.windowSquares) < limits_.half * mean(without.windowSquares);
}

bool Worth::material(const FitResult& without, const FitResult& with) const {
  std::vector<double> gains(with.windowSquares.size());
  for (size_t k = 0; k < gains.size(); ++k) gains[k] = without.windowSquares[k] - with.windowSquares[k];
  const double back = mean(gains), unit = floor_ * floor_;
  std::sort(gains.begin(), gains.end());
  gains.resize(gains.size() - gains.size() / 10);
  // If few windows make up the gain, it has to be larger: single windows err by more than sensors explain.
  const bool spread = mean(gains) > limits_.half * unit || back > std::pow(limits_.nearFloor, 2) * unit;
  // A fitted start takes up some of what a model lacks, and all that a restart's noise adds: restarts count, too.
  const bool seen = !baseAtFloor() || restarts_ > std::pow(limits_.atFloor, 2) * unit;
  // Beside a much larger effect an effect needs no share of the base's error if it takes nearly all away that is left.
  const bool clears = back > std::pow(limits_.settled, 2) * unit &&
                      mean(with.windowSquares) < limits_.little * mean(without.windowSquares);
  const bool position = seen && spread && back > unit && (back > limits_.negligible * base_ || clears);
  const double noise = currentNoise();
  const double currentBack = without.currentSquares - with.currentSquares;
  return position || (currentBack > limits_.half * without.currentSquares && currentBack > noise * noise);
}

double Worth::leastBack(bool inFew) const {
  const double unit = floor_ * floor_;
  const double unseen = std::max(0.0, std::pow(limits_.atFloor, 2) * unit - std::max(base_, restarts_));
  return std::max({unseen, (inFew ? std::pow(limits_.nearFloor, 2) : 1.0) * unit, limits_.hardlyAny * base_});
}

std::optional<double> Worth::leastCurrentBack() const {
  if (!input_.seen.currentSeen) return {};
  // A part of what errs with the effect in it.
  return std::max(limits_.half / (1.0 - limits_.half) * baseCurrent_, std::pow(currentNoise(), 2));
}

double Worth::currentNoise() const {
  double noise = 0.0;
  for (const Track& track : input_.tracks) noise = std::max(noise, track.currentNoise);
  return noise;
}

bool Worth::currentErrs(const FitResult& fit) const {
  return input_.seen.currentSeen && fit.currentSquares > limits_.farLess * baseCurrent_ &&
         fit.currentSquares > std::pow(limits_.settled * currentNoise(), 2);
}

bool Worth::baseAtFloor() const {
  return base_ < std::pow(limits_.atFloor * floor_, 2);
}

double Worth::floors(const FitResult& fit) const {
  return std::sqrt(mean(fit.windowSquares)) / floor_;
}

}  // namespace breakaway
