// Intervals of effects' sizes by the profile of the error, where the covariance's own include zero.
#pragma once

#include <functional>

#include "diagnose/fit/windowed_fit.h"

namespace breakaway {

/// Whether the data exclude that the effect of that number is absent, though the covariance may not: `without` is the
/// fit without it. The squares rise by more than those at the 95 % bound of a parabola with the covariance's width
/// would. A covariance is that of the tangent at the best fit; where another parameter can stand in for a small change
/// of the size, but not for all of it, it reaches over zero, and the squares don't. The threshold is scaled by the
/// ratio of the covariance robust against correlation to the plain one (J. T. Kent, Biometrika 69(1), 1982).
bool excludesZero(const FitResult& with, size_t effect, const FitResult& without);

/// A fit of a model in which the size of the effect of that number is held, with these weights of the channels.
using HeldFit = std::function<FitResult(const Model& model, size_t effect, const Weights& weights)>;

/// Moves the bound of each size on zero's side to the largest of half, a quarter and an eighth of its value that the
/// data exclude; where not even the eighth is, it stays as it is. Sizes of effects that happen once stay, too.
void profileSizes(FitResult& fit, const HeldFit& heldFit);

}  // namespace breakaway
