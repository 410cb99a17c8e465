#include "diagnose/fit/cross_validation.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "dense/dense_solve.h"
#include "diagnose/fit/motion.h"

namespace breakaway {

namespace {

constexpr double runaway = 10.0;    ///< units: mean squares of the base model
constexpr double suspicious = 1.3;  ///< times the error of the common fit
constexpr int mostHalvings = 3;

/// What a cross-validation works on.
struct Validation {
  const FitResult& fit;
  const ParameterVector& parameters;
  const std::vector<Track>& tracks;
  const std::vector<Window>& windows;
  const std::vector<double>& windowWeights;
  const std::vector<int>& fold;

  /// Weighted squared residuals per channel of the windows that are in the fold (or else not in it).
  template <typename Act>
  void simulate(const Eigen::VectorXd& x, int one, bool inside, Weights unit, Act act) const {
    const Model model = parameters.at(x);
    const std::vector<MotionState> hidden = hiddenStates(model, tracks, windows);
    std::vector<size_t> here;
    for (size_t w = 0; w < windows.size(); ++w) {
      if ((fold[w] == one) == inside) here.push_back(w);
    }
    std::vector<std::optional<WindowResidual>> simulated(here.size());
    inParallel(here.size(), [&](size_t k) {
      const size_t w = here[k];
      const double factor = windowWeights.empty() ? 1.0 : windowWeights[w];
      simulated[k].emplace(tracks[windows[w].track], windows[w],
                           Weights{factor * unit.position, factor * unit.current});
      simulated[k]->fit(model, hidden[w]);
    });
    for (size_t k = 0; k < here.size(); ++k) act(here[k], *simulated[k]);
  }
  double costOfOthers(const Eigen::VectorXd& x, int one) const {
    double cost = 0.0;
    simulate(x, one, false, fit.weights,
             [&cost](size_t, const WindowResidual& window) { cost += window.residual().squaredNorm(); });
    return cost;
  }
};

double perSample(const WindowResidual& window) {
  const Eigen::VectorXd& r = window.residual();
  double sum = r.head(window.positions()).squaredNorm() / static_cast<double>(window.positions());
  if (window.currents() > 0)
    sum += r.segment(window.positions(), window.currents()).squaredNorm() / static_cast<double>(window.currents());
  return sum;
}

}  // namespace

std::vector<double> crossValidated(const FitResult& fit, const std::vector<Track>& tracks,
                                   const std::vector<Window>& windows, const std::vector<double>& windowWeights,
                                   const std::vector<int>& fold, int foldCount, Weights unit) {
  const ParameterVector& parameters = *fit.parameters;
  const Validation data{fit, parameters, tracks, windows, windowWeights, fold};
  const Eigen::Index size = fit.x.size();
  std::vector<double> squares(windows.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  for (const WindowDerivative& window : fit.windows) normal += window.jacobian.transpose() * window.jacobian;
  for (int one = 0; one < foldCount; ++one) {
    Eigen::MatrixXd rest = normal;
    Eigen::VectorXd score = Eigen::VectorXd::Zero(size);
    double common = 0.0, others = 0.0;
    for (size_t w = 0; w < windows.size(); ++w) {
      if (fold[w] != one) {
        others += fit.windows[w].residual.squaredNorm();
        continue;
      }
      rest -= fit.windows[w].jacobian.transpose() * fit.windows[w].jacobian;
      score += fit.windows[w].jacobian.transpose() * fit.windows[w].residual;
      const double factor = unit.position / fit.weights.position;
      common += factor * factor * fit.windows[w].residual.head(fit.windows[w].positions).squaredNorm() /
                static_cast<double>(fit.windows[w].positions);
    }
    rest.diagonal() += 1e-4 * normal.diagonal() + fit.priorPrecision;
    Eigen::VectorXd step = score;
    if (size > 0) {  // with every value trusted there is nothing to move
      rest.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
      step = solveSymmetric(rest, score);
    }
    for (int halvings = 0;; ++halvings) {
      Eigen::VectorXd x = fit.x + step;
      for (Eigen::Index k = 0; k < size; ++k) x[k] = std::clamp(x[k], parameters.lower(k), parameters.upper(k));
      double sum = 0.0;
      data.simulate(x, one, true, unit, [&](size_t w, const WindowResidual& window) {
        squares[w] = perSample(window);
        sum += window.residual().head(window.positions()).squaredNorm() / static_cast<double>(window.positions());
      });
      // Where even the other folds err more, the step went too far: no fit to them would take it.
      if (halvings == mostHalvings || !(sum > suspicious * common) || data.costOfOthers(x, one) <= others) break;
      step *= halvings + 1 == mostHalvings ? 0.0 : 0.5;
    }
  }
  // How far a window runs away says no more than that it does.
  for (double& one : squares) one = std::isfinite(one) ? std::min(one, runaway) : runaway;
  return squares;
}

Comparison compare(const std::vector<double>& before, const std::vector<double>& after, std::uint64_t seed) {
  Comparison out;
  std::vector<double> gain(before.size());
  for (size_t k = 0; k < before.size(); ++k) gain[k] = before[k] - after[k];
  const double scale = std::max(mean(before), 1e-300), middle = mean(gain);
  double variance = 0.0;
  for (const double one : gain) variance += (one - middle) * (one - middle);
  const auto n = static_cast<double>(gain.size());
  const double error = std::sqrt(variance / std::max(1.0, n - 1.0) / n);
  out.relative = middle / scale;
  out.inErrors = error > 0.0 ? middle / error : 0.0;
  out.interval = bootstrap(gain.size(), 1000, seed, [&](std::span<const size_t> blocks) {
    double sumGain = 0.0, sumBefore = 0.0;
    for (const size_t block : blocks) {
      sumGain += gain[block];
      sumBefore += before[block];
    }
    return sumGain / std::max(sumBefore, 1e-300);
  });
  return out;
}

double signFlipPValue(const std::vector<double>& before, const std::vector<double>& after, std::uint64_t seed) {
  std::vector<double> gain(before.size());
  for (size_t k = 0; k < before.size(); ++k) gain[k] = std::sqrt(before[k]) - std::sqrt(after[k]);
  const double seen = mean(gain);
  Random random(seed);
  size_t beaten = 0;
  constexpr size_t flips = 9999;
  for (size_t flip = 0; flip < flips; ++flip) {
    double sum = 0.0;
    for (const double one : gain) sum += random.bits() >> 63 ? one : -one;
    if (sum / static_cast<double>(gain.size()) >= seen) ++beaten;
  }
  return static_cast<double>(1 + beaten) / static_cast<double>(1 + flips);
}

}  // namespace breakaway
