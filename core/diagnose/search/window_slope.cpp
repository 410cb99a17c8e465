#include "diagnose/search/window_slope.h"

#include <Eigen/Dense>
#include <cmath>

#include "diagnose/fit/motion.h"

namespace breakaway {

namespace {

constexpr double little = 1e-3;     ///< of a shape's amplitude
constexpr double hardlyOwn = 1e-6;  ///< of a squared column: the fit's own parameters do the same

bool slopesTell(const Effect& effect, const Shape& shape, DriveInput drive) {
  return shape.size() == 1 && effect.memory() == 0 && !effect.growsAtRest() && !effect.happensOnce() &&
         !effect.shapesInput(drive) && effect.frictionStiffness(shape.front()) <= 0.0;
}

/// Sums over all windows, J the fit's Jacobian, c the effect's column and r the residual.
struct Sums {
  Eigen::MatrixXd normal;                        ///< JᵀJ
  Eigen::VectorXd shared, left;                  ///< Jᵀc, Jᵀr
  double own = 0.0, score = 0.0, squares = 0.0;  ///< cᵀc, cᵀr, rᵀr
};

Sums sumsOf(const SearchInput& input, const FitResult& fit, const Effect& effect, const Shape& shape) {
  const Eigen::Index size = fit.x.size();
  Sums sums{Eigen::MatrixXd(fit.priorPrecision.asDiagonal()), Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)};
  const auto modelAt = [&](double amplitude) {
    Pick pick;
    pick.effect = &effect;
    pick.parameters = effect.scaled(shape, std::vector<double>{amplitude});
    return with(input, fit.model, pick);
  };
  const Model without = modelAt(0.0), with = modelAt(little);
  const auto& windows = input.split.train;
  const auto hidden = hiddenStates(without, input.tracks, windows);
  for (size_t w = 0; w < windows.size(); ++w) {
    const WindowDerivative& known = fit.windows[w];
    const double factor = input.windowWeights.empty() ? 1.0 : input.windowWeights[w];
    WindowResidual window(input.tracks[windows[w].track], windows[w],
                          {factor * fit.weights.position, factor * fit.weights.current});
    window.fit(without, hidden[w]);
    const Eigen::VectorXd column = window.linearColumn(with, little);
    if (column.size() != known.jacobian.rows() || !column.allFinite()) continue;
    sums.normal += known.jacobian.transpose() * known.jacobian;
    sums.shared += known.jacobian.transpose() * column;
    sums.left += known.jacobian.transpose() * known.residual;
    sums.own += column.squaredNorm();
    sums.score += column.dot(known.residual);
    sums.squares += known.residual.squaredNorm();
  }
  return sums;
}

}  // namespace

SlopePick slopePick(const SearchInput& input, const FitResult& fit, const Effect& effect) {
  SlopePick best;
  best.pick.effect = &effect;
  if (remembers(fit.model) || fit.windows.size() != input.split.train.size()) return best;
  for (const Shape& shape : effect.shapes(input.seen)) {
    if (!slopesTell(effect, shape, fit.model.input)) continue;
    const Sums sums = sumsOf(input, fit, effect, shape);
    const Eigen::VectorXd beside = sums.normal.ldlt().solve(sums.shared);
    const double own = sums.own - beside.dot(sums.shared), score = sums.score - beside.dot(sums.left);
    if (!(own > hardlyOwn * sums.own)) continue;
    const double part = score * score / own / sums.squares;
    auto parameters = effect.scaled(shape, std::vector<double>{-score / own});
    if (!(part > best.part) || !plausible(effect, parameters, input.seen)) continue;
    best.part = part;
    best.pick.shape = shape;
    best.pick.parameters = std::move(parameters);
  }
  return best;
}

}  // namespace breakaway
