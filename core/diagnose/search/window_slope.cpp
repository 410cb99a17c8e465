#include "diagnose/search/window_slope.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/fit/motion.h"

namespace breakaway {

namespace {

constexpr double little = 1e-3;     ///< of a shape's amplitude
constexpr double hardlyOwn = 1e-6;  ///< of a squared column: the fit's own parameters do the same
constexpr size_t looksAtWindow = 50;

bool slopesTell(const Effect& effect, const std::vector<Shape>& shapes, DriveInput drive) {
  if (shapes.empty() || effect.hidden() != nullptr || effect.growsAtRest() || effect.input(drive) != nullptr)
    return false;
  const Shape& any = shapes.front();
  return (any.size() == 1 || shapes.size() == 1) && effect.elastic() == nullptr;
}

/// One shape, and sums over the windows in which it acts: J the fit's Jacobian, C the shape's columns, r the residual.
struct SlopeCandidate {
  Shape shape;
  size_t track = everyTrack;
  Eigen::MatrixXd shared, own;  ///< JᵀC, CᵀC
  Eigen::VectorXd score;        ///< Cᵀr

  std::vector<double> parameters(const Effect& effect, const Eigen::VectorXd& amplitude) const {
    return effect.scaled(shape, {amplitude.data(), static_cast<size_t>(amplitude.size())});
  }
};

/// What the fit can do itself, over all windows: JᵀJ, Jᵀr, rᵀr.
struct Own {
  Eigen::MatrixXd normal;
  Eigen::VectorXd left;
  double squares = 0.0;
};

std::vector<SlopeCandidate> candidatesOf(const SearchInput& input, const Effect& effect,
                                         const std::vector<Shape>& shapes, Eigen::Index size) {
  std::vector<SlopeCandidate> candidates;
  const size_t apart = effect.happensOnce() ? input.tracks.size() : 1;
  for (size_t track = 0; track < apart; ++track) {
    for (const Shape& shape : shapes) {
      const auto width = static_cast<Eigen::Index>(shape.size());
      candidates.push_back({shape, effect.happensOnce() ? track : everyTrack, Eigen::MatrixXd::Zero(size, width),
                            Eigen::MatrixXd::Zero(width, width), Eigen::VectorXd::Zero(width)});
    }
  }
  return candidates;
}

/// Whether what happens once happens in this window.
bool actsIn(const Effect& effect, const SlopeCandidate& candidate, const SearchInput& input, const Window& window) {
  if (!effect.happensOnce()) return true;
  if (candidate.track != window.track) return false;
  const auto& time = input.tracks[window.track].time;
  Situation at;
  for (size_t look = 0; look <= looksAtWindow; ++look) {
    at.time_s = time[window.first + (window.last - window.first) * look / looksAtWindow];
    if (effect.term(candidate.shape.front(), at).load_Nm != 0.0) return true;
  }
  return false;
}

Pick pickAt(const Effect& effect, const SlopeCandidate& candidate, const Eigen::VectorXd& amplitude) {
  Pick pick;
  pick.effect = &effect;
  pick.shape = candidate.shape;
  pick.track = candidate.track;
  pick.parameters = candidate.parameters(effect, amplitude);
  return pick;
}

Own addSlopes(const SearchInput& input, const FitResult& fit, const Effect& effect,
              std::vector<SlopeCandidate>& candidates) {
  const Eigen::Index size = fit.x.size(), width = candidates.front().score.size();
  Own own{Eigen::MatrixXd(fit.priorPrecision.asDiagonal()), Eigen::VectorXd::Zero(size)};
  const auto modelAt = [&](const SlopeCandidate& candidate, const Eigen::VectorXd& amplitude) {
    return with(input, fit.model, pickAt(effect, candidate, amplitude));
  };
  const auto& windows = input.split.train;
  const auto hidden = hiddenStates(fit.model, input.tracks, windows);
  for (size_t w = 0; w < windows.size(); ++w) {
    const double weight = input.windowWeights.empty() ? 1.0 : input.windowWeights[w];
    const double unweighted = effect.happensOnce() ? 1.0 / weight : 1.0;
    const Eigen::MatrixXd jacobian = unweighted * fit.windows[w].jacobian;
    const Eigen::VectorXd residual = unweighted * fit.windows[w].residual;
    own.normal += jacobian.transpose() * jacobian;
    own.left += jacobian.transpose() * residual;
    own.squares += residual.squaredNorm();
    const double factor = weight * unweighted;
    WindowResidual window(input.tracks[windows[w].track], windows[w],
                          {factor * fit.weights.position, factor * fit.weights.current});
    bool fitted = false;
    Eigen::MatrixXd columns(residual.size(), width);
    for (SlopeCandidate& one : candidates) {
      if (!actsIn(effect, one, input, windows[w])) continue;
      // Without any of it all shapes are one.
      if (!std::exchange(fitted, true)) window.fit(modelAt(one, Eigen::VectorXd::Zero(width)), hidden[w]);
      if (window.rows() != residual.size()) break;
      for (Eigen::Index k = 0; k < width; ++k)
        columns.col(k) = window.linearColumn(modelAt(one, little * Eigen::VectorXd::Unit(width, k)), little);
      if (!columns.allFinite()) continue;
      one.shared += jacobian.transpose() * columns;
      one.own += columns.transpose() * columns;
      one.score += columns.transpose() * residual;
    }
  }
  return own;
}

}  // namespace

SlopePick slopePick(const SearchInput& input, const FitResult& fit, const Effect& effect) {
  SlopePick best;
  best.pick.effect = &effect;
  const auto shapes = effect.shapes(input.seen);
  if (remembers(fit.model) || fit.windows.size() != input.split.train.size() ||
      !slopesTell(effect, shapes, fit.model.input))
    return best;
  std::vector<SlopeCandidate> candidates = candidatesOf(input, effect, shapes, fit.x.size());
  const Own fits = addSlopes(input, fit, effect, candidates);
  const auto normal = fits.normal.ldlt();
  const Eigen::VectorXd step = normal.solve(fits.left);
  for (const SlopeCandidate& one : candidates) {
    const Eigen::MatrixXd own = one.own - one.shared.transpose() * normal.solve(one.shared);
    const Eigen::VectorXd score = one.score - one.shared.transpose() * step;
    if (!(own.trace() > hardlyOwn * one.own.trace())) continue;
    const Eigen::VectorXd amplitude = -own.ldlt().solve(score);
    const double part = -amplitude.dot(score) / fits.squares;
    Pick pick = pickAt(effect, one, amplitude);
    if (!(part > best.part) || !plausible(effect, pick.parameters, input.seen)) continue;
    best = {std::move(pick), part};
  }
  return best;
}

}  // namespace breakaway
