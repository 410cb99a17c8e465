#include "diagnose/fit/size_profile.h"

#include <Eigen/Core>
#include <cmath>

#include "dense/dense_solve.h"
#include "diagnose/effects/catalogue.h"

namespace breakaway {

namespace {

/// Squares of the residuals, weighted as `unit` weighs the channels.
double squaresOf(const FitResult& fit, const Weights& unit) {
  const double position = std::pow(unit.position / fit.weights.position, 2);
  const double current = fit.weights.current > 0.0 ? std::pow(unit.current / fit.weights.current, 2) : 1.0;
  double squares = 0.0;
  for (const WindowDerivative& window : fit.windows) {
    const Eigen::Index others = window.residual.size() - window.positions;
    squares += position * window.residual.head(window.positions).squaredNorm() +
               current * window.residual.tail(others).squaredNorm();
  }
  return squares;
}

/// By how much the squares rise where the size leaves its 95 % interval, if they are a parabola.
double risesBy(const FitResult& fit, Eigen::Index size) {
  Eigen::MatrixXd normal = fit.priorPrecision.asDiagonal();
  for (const WindowDerivative& window : fit.windows) normal += window.jacobian.transpose() * window.jacobian;
  normal.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
  const double plain = solveSymmetric(normal, Eigen::VectorXd::Unit(normal.rows(), size))[size];
  return std::pow(fit.errors, 2) * fit.covariance(size, size) / plain;
}

bool includesZero(const Parameter& one) {
  return one.low95 < 0.0 && one.high95 > 0.0;
}

}  // namespace

bool excludesZero(const FitResult& with, size_t effect, const FitResult& without) {
  const auto size = with.parameters ? with.parameters->sizeOf(effect) : std::nullopt;
  if (!size || !with.usable || !without.usable) return false;
  return squaresOf(without, with.weights) - squaresOf(with, with.weights) > risesBy(with, *size);
}

void profileSizes(FitResult& fit, const HeldFit& heldFit) {
  for (size_t effect = 0; effect < fit.model.effects.size(); ++effect) {
    // What happens once rests on a single stretch, which may err for a reason of its own: no other one confirms it.
    if (findEffect(fit.model.effects[effect].effect)->happensOnce()) continue;
    Parameter& shown = fit.model.effects[effect].parameters.front();
    if (!includesZero(shown)) continue;
    Model model = fit.model;
    for (const double part : {0.5, 0.25, 0.125}) {
      const double size = part * shown.value;
      model.effects[effect].parameters.front().value = size;
      const FitResult held = heldFit(model, effect, fit.weights);
      if (excludesZero(fit, effect, held)) {
        (shown.value > 0.0 ? shown.low95 : shown.high95) = size;
        break;
      }
      if (!held.usable) break;
      model = held.model;  // the next one is near
    }
  }
}

}  // namespace breakaway
