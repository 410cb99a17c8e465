#include "diagnose/fit/windowed_fit.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/distributions.h"
#include "base/parallel.h"
#include "base/statistics.h"
#include "dense/dense_solve.h"
#include "diagnose/fit/motion.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/simulator.h"

namespace breakaway {

namespace {

constexpr double idleSquare = 1e-6;     ///< of the mean: an error that only standing windows have
constexpr double priorDeviation = 1.1;  ///< of the logarithm of a start value: a factor of three
constexpr double nudge = 1e-5;          ///< finite difference of a parameter of order one
constexpr double swingingNudge = 5e-3;  ///< the same where impacts make residuals rough
constexpr double windowsTogether = 3.0;
constexpr double hardlyDiffers = 1e-3;  ///< of the cost
constexpr double boundFirmness = 1.0;   ///< pull back to a bound, per unit beyond it

/// The nearest x within the bounds. Ceres' own bounds cost a line search with several Jacobians per step.
Eigen::VectorXd clamped(const ParameterVector& parameters, const Eigen::VectorXd& x) {
  Eigen::VectorXd out = x;
  for (Eigen::Index k = 0; k < x.size(); ++k) out[k] = std::clamp(x[k], parameters.lower(k), parameters.upper(k));
  return out;
}

/// Hidden states at every window's start, for the last x and its nudged neighbours.
class HiddenStates {
 public:
  HiddenStates(const ParameterVector& parameters, const std::vector<Track>& tracks, const std::vector<Window>& windows)
      : parameters_(parameters), tracks_(tracks), windows_(windows) {}

  /// Makes what at() gives: at x, and where `nudged` isn't empty, at each of these, one per parameter.
  void prepare(const Eigen::VectorXd& x, const std::vector<Eigen::VectorXd>& nudged) {
    if (states_.empty() || x_.size() != x.size() || x_ != x) {
      x_ = x;
      states_.assign(static_cast<size_t>(x.size()) + 1, {});
    }
    inParallel(nudged.size() + 1, [&](size_t k) {
      if (states_[k].empty()) states_[k] = hiddenStates(parameters_.at(k == 0 ? x : nudged[k - 1]), tracks_, windows_);
    });
  }
  /// Of `window` at the prepared x, `nudged` −1 for x itself or the number of the nudged parameter.
  const MotionState& at(Eigen::Index nudged, size_t window) const {
    return states_[static_cast<size_t>(nudged + 1)][window];
  }

 private:
  const ParameterVector& parameters_;
  const std::vector<Track>& tracks_;
  const std::vector<Window>& windows_;
  Eigen::VectorXd x_;
  std::vector<std::vector<MotionState>> states_;
};

/// All windows at one x after the other: a window's start moves on with each.
class Evaluation final : public ceres::EvaluationCallback {
 public:
  Evaluation(const ParameterVector& parameters, const std::vector<Track>& tracks, const std::vector<Window>& windows,
             bool exact)
      : parameters_(parameters), hidden_(parameters, tracks, windows), exact_(exact) {
    const Eigen::VectorXd start = parameters.start();
    for (const Window& window : windows) windows_.emplace_back(tracks[window.track], window, Weights{1.0, 1.0});
    hidden_.prepare(start, {});
    inParallel(windows_.size(), [&](size_t w) { windows_[w].fit(parameters.at(start), hidden_.at(-1, w)); });
    derived_.resize(windows_.size());
  }
  std::vector<WindowResidual>& windows() { return windows_; }
  const WindowDerivative& of(size_t window) const { return derived_[window]; }
  std::vector<WindowDerivative>& all() { return derived_; }

  /// `asked`: where Ceres keeps what it asks for.
  void follow(const double* asked) { asked_ = asked; }
  void PrepareForEvaluation(bool jacobian, bool) override {
    at(clamped(parameters_, Eigen::Map<const Eigen::VectorXd>(asked_, parameters_.size())), jacobian);
  }
  /// Residuals, and Jacobians if they are wanted. `refit`: also if x is the last one.
  void at(const Eigen::VectorXd& x, bool jacobian, bool refit = false) {
    const bool fitted = !refit && last_.size() == x.size() && last_ == x;
    last_ = x;
    const bool simulated = exact_ || std::any_of(windows_.begin(), windows_.end(),
                                                 [](const WindowResidual& one) { return one.remembers(); });
    std::vector<Eigen::VectorXd> near;  // x with one parameter nudged
    for (Eigen::Index p = 0; jacobian && p < x.size(); ++p) {
      near.push_back(x);
      near.back()[p] += step(x, p);
    }
    hidden_.prepare(x, simulated ? near : std::vector<Eigen::VectorXd>{});
    inParallel(windows_.size(), [&](size_t w) {
      WindowResidual& window = windows_[w];
      if (!fitted) window.fit(parameters_.at(x), hidden_.at(-1, w));
      WindowDerivative& out = derived_[w];
      out.residual = window.residual();
      out.positions = window.positions();
      if (!jacobian) return;
      out.jacobian.resize(window.rows(), x.size());
      for (Eigen::Index p = 0; p < x.size(); ++p) {
        const Model model = parameters_.at(near[static_cast<size_t>(p)]);
        out.jacobian.col(p) = exact_ || window.remembers() ? window.column(model, hidden_.at(p, w), step(x, p))
                                                           : window.linearColumn(model, step(x, p));
      }
    });
  }

 private:
  double step(const Eigen::VectorXd& x, Eigen::Index p) const {
    const double far = windows_.front().swings() ? swingingNudge : nudge;
    return x[p] + far > parameters_.upper(p) ? -far : far;
  }

  const ParameterVector& parameters_;
  HiddenStates hidden_;
  bool exact_;
  std::vector<WindowResidual> windows_;
  std::vector<WindowDerivative> derived_;
  Eigen::VectorXd last_;
  const double* asked_ = nullptr;
};

/// One window of an evaluation.
class WindowCost final : public ceres::CostFunction {
 public:
  WindowCost(const ParameterVector& parameters, Evaluation& evaluation, size_t window)
      : parameters_(parameters), evaluation_(evaluation), window_(window) {
    set_num_residuals(static_cast<int>(evaluation.windows()[window].rows()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters.size()));
  }
  bool Evaluate(double const* const* at, double* residuals, double** jacobians) const override {
    const WindowDerivative& got = evaluation_.of(window_);
    const bool wanted = jacobians != nullptr && jacobians[0] != nullptr;
    if (!got.residual.allFinite() || (wanted && !got.jacobian.allFinite())) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, got.residual.size()) = got.residual;
    if (!wanted) return true;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor> jacobian(jacobians[0], got.jacobian.rows(), got.jacobian.cols());
    jacobian = got.jacobian;
    for (Eigen::Index k = 0; k < parameters_.size(); ++k) {
      const bool held = at[0][k] < parameters_.lower(k) || at[0][k] > parameters_.upper(k);
      if (held) jacobian.col(k).setZero();
    }
    return true;
  }

 private:
  const ParameterVector& parameters_;
  Evaluation& evaluation_;
  size_t window_;
};

/// Holds start values of positive quantities that no data reach, and draws back to the bounds.
class PriorCost final : public ceres::CostFunction {
 public:
  PriorCost(const ParameterVector& parameters, Eigen::VectorXd start, double weight)
      : parameters_(parameters), start_(std::move(start)), weight_(weight / priorDeviation) {
    set_num_residuals(static_cast<int>(2 * start_.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(start_.size()));
  }
  bool Evaluate(double const* const* at, double* residuals, double** jacobians) const override {
    const Eigen::Index size = start_.size();
    const bool wanted = jacobians != nullptr && jacobians[0] != nullptr;
    if (wanted) std::fill_n(jacobians[0], 2 * size * size, 0.0);
    for (Eigen::Index k = 0; k < size; ++k) {
      const double weight = parameters_.logarithmic(k) ? weight_ : 0.0;
      const double beyond = at[0][k] - std::clamp(at[0][k], parameters_.lower(k), parameters_.upper(k));
      residuals[k] = weight * (at[0][k] - start_[k]);
      residuals[size + k] = boundFirmness * beyond;
      if (!wanted) continue;
      jacobians[0][k * size + k] = weight;
      jacobians[0][(size + k) * size + k] = beyond != 0.0 ? boundFirmness : 0.0;
    }
    return true;
  }

 private:
  const ParameterVector& parameters_;
  Eigen::VectorXd start_;
  double weight_;
};

/// Ends on request or when its time is over, and where a step that is no better hardly differs: shorter ones would
/// drown in what evaluation itself changes, which moves each window's start on.
class Ending final : public ceres::IterationCallback {
 public:
  Ending(std::stop_token stop, TimeLimit time) : stop_(std::move(stop)), time_(std::move(time)) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    if (stop_.stop_requested()) return ceres::SOLVER_ABORT;
    const bool alike = !step.step_is_successful && std::abs(step.cost_change) < hardlyDiffers * step.cost;
    return alike || time_.over() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  std::stop_token stop_;
  TimeLimit time_;
};

/// A step that fails is tried again: nothing to print. Set once, for fits may run side by side.
void silenceSolver() {
  static const bool silent = [] {
    FLAGS_minloglevel = 3;
    return true;
  }();
  static_cast<void>(silent);
}

}  // namespace

FitResult fitWindows(const ParameterVector& parameters, const std::vector<Track>& tracks,
                     const std::vector<Window>& windows, const FitOptions& options) {
  FitResult result;
  const Eigen::VectorXd start = parameters.start();
  Eigen::VectorXd x = start;
  Evaluation evaluation(parameters, tracks, windows, options.exact);
  std::vector<WindowResidual>& residuals = evaluation.windows();
  result.weights = options.weights.value_or(weightsOf(residuals, tracks, windows));
  evaluation.follow(x.data());
  ceres::Problem::Options shared;
  shared.evaluation_callback = &evaluation;
  ceres::Problem problem(shared);
  double count = 0.0;
  for (size_t w = 0; w < windows.size(); ++w) {
    const double factor = options.windowWeights.empty() ? 1.0 : options.windowWeights[w];
    residuals[w].reweigh({factor * result.weights.position, factor * result.weights.current});
    count += static_cast<double>(residuals[w].rows());
    if (x.size() > 0) problem.AddResidualBlock(new WindowCost(parameters, evaluation, w), nullptr, x.data());
  }
  const double priorWeight = 0.1 * std::sqrt(count / static_cast<double>(windows.size()));
  if (x.size() > 0) problem.AddResidualBlock(new PriorCost(parameters, start, priorWeight), nullptr, x.data());
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  solver.initial_trust_region_radius = 30.0;  // steps that let windows run away are the rule far from the answer
  solver.max_num_iterations = options.iterations + 4;
  solver.function_tolerance = options.tolerance;
  solver.parameter_tolerance = 1e-7;
  solver.logging_type = ceres::SILENT;
  Ending ending(options.stop, options.time);
  solver.callbacks.push_back(&ending);
  ceres::Solver::Summary summary;
  silenceSolver();
  ceres::Solve(solver, &problem, &summary);

  x = clamped(parameters, x);
  result.parameters = parameters;
  result.x = x;
  result.usable = summary.IsSolutionUsable() && !options.stop.stop_requested();
  result.termination = ceres::TerminationTypeToString(summary.termination_type);
  const Eigen::Index size = x.size();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size), meat = normal;
  std::map<std::pair<size_t, long>, Eigen::VectorXd>
      clusters;  // windows of one second of one track, which overlap or adjoin
  double squares = 0.0, positions = 0.0, currentSquares = 0.0, currents = 0.0;
  evaluation.at(x, true, true);
  result.windows = std::move(evaluation.all());
  for (size_t w = 0; w < residuals.size(); ++w) {
    const WindowResidual& residual = residuals[w];
    const WindowDerivative& window = result.windows[w];
    const Eigen::VectorXd score = window.jacobian.transpose() * window.residual;
    normal += window.jacobian.transpose() * window.jacobian;
    const Track& track = tracks[windows[w].track];
    const double span = track.time[windows[w].last] - track.time[windows[w].first];
    const double length = options.exact ? windowsTogether * span : span;  // overlapping ones hang together longer
    auto& cluster =
        clusters
            .try_emplace({windows[w].track, std::lround(std::floor(track.time[windows[w].first] / length + 1e-6))},
                         Eigen::VectorXd::Zero(size))
            .first->second;
    cluster += score;
    const double factor = options.windowWeights.empty() ? 1.0 : options.windowWeights[w];
    const double sum =
        window.residual.head(window.positions).squaredNorm() / std::pow(factor * result.weights.position, 2);
    result.windowSquares.push_back(sum / static_cast<double>(window.positions));
    squares += sum;
    positions += static_cast<double>(window.positions);
    if (residual.currents() > 0) {
      currentSquares += window.residual.segment(window.positions, residual.currents()).squaredNorm() /
                        std::pow(factor * result.weights.current, 2);
      currents += static_cast<double>(residual.currents());
    }
  }
  for (const auto& [where, score] : clusters) meat += score * score.transpose();
  result.rmse = std::sqrt(squares / positions);
  result.usable = result.usable && std::isfinite(result.rmse);
  result.currentSquares = currentSquares / std::max(currents, 1.0);
  const double precision = std::pow(priorWeight / priorDeviation, 2);
  result.priorPrecision = Eigen::VectorXd::Zero(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    if (!parameters.logarithmic(k)) continue;
    // What the prior holds has the prior's own doubt.
    result.priorPrecision[k] = precision;
    normal(k, k) += precision;
    meat(k, k) += precision * precision * priorDeviation * priorDeviation;
  }
  if (size > 0) normal.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
  const Eigen::MatrixXd inverse = size > 0 ? inverseOfSymmetric(normal) : Eigen::MatrixXd(0, 0);
  const auto n = static_cast<double>(clusters.size());
  result.covariance = inverse * meat * inverse * (n / std::max(1.0, n - static_cast<double>(size)));
  result.errors = student95(n - 1.0);
  result.model = parameters.withIntervals(x, result.covariance, result.errors);
  return result;
}

std::vector<double> residualSquares(const Model& model, const std::vector<Track>& tracks,
                                    const std::vector<Window>& windows) {
  const std::vector<MotionState> hidden = hiddenStates(model, tracks, windows);
  std::vector<double> squares(windows.size());
  inParallel(windows.size(), [&](size_t w) {
    WindowResidual residual(tracks[windows[w].track], windows[w], {1.0, 0.0});
    residual.fit(model, hidden[w]);
    squares[w] =
        residual.residual().head(residual.positions()).squaredNorm() / static_cast<double>(residual.positions());
  });
  return squares;
}

std::vector<double> robustWeights(const std::vector<double>& windowSquares) {
  // An axis that stands errs by nothing and says nothing of what is usual, though it may stand most of the time.
  std::vector<double> moving = windowSquares;
  const double idle = idleSquare * mean(windowSquares);
  std::erase_if(moving, [idle](double one) { return !(one > idle); });
  if (moving.empty()) return std::vector<double>(windowSquares.size(), 1.0);
  const double usual = std::sqrt(quantile(moving, 0.5));
  std::vector<double> weights;
  weights.reserve(windowSquares.size());
  for (const double squares : windowSquares)
    weights.push_back(std::min(1.0, 2.5 * usual / std::max(std::sqrt(squares), 1e-300)));
  return weights;
}

std::vector<double> scoreWindows(const Model& model, const std::vector<Track>& tracks,
                                 const std::vector<Window>& windows) {
  const std::vector<MotionState> hidden = hiddenStates(model, tracks, windows);
  std::vector<double> squares(windows.size());
  inParallel(windows.size(), [&](size_t w) {
    const Window& window = windows[w];
    const Track& track = tracks[window.track];
    if (window.errorIn == ErrorIn::torque) {
      const Eigen::VectorXd left = TorqueResidual(track, window).of(model);
      squares[w] = left.squaredNorm() / static_cast<double>(left.size());
      return;
    }
    Simulator simulator(model, track, window.first, window.last);
    MotionState state = simulator.restart(window.first, hidden[w]);
    double sum = 0.0, n = 0.0;
    for (size_t k = window.first;; ++k) {
      if (track.seen[k]) {
        const double error = simulator.reading(state) - track.reading(k);
        sum += error * error;
        n += 1.0;
      }
      if (k == window.last) break;
      simulator.run(state, k, k + 1);
    }
    squares[w] = sum / std::max(n, 1.0);
  });
  return squares;
}

double typicalSquare(std::vector<double> squares) {
  std::sort(squares.begin(), squares.end());
  squares.resize(std::max<size_t>(1, squares.size() - squares.size() / 10));
  return mean(squares);
}

}  // namespace breakaway
