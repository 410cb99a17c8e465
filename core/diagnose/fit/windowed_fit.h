// Least squares over restarted windows: the model is simulated through each window from a free initial state.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/time_limit.h"
#include "diagnose/fit/parameter_vector.h"
#include "diagnose/fit/window_residual.h"

namespace breakaway {

struct FitOptions {
  int iterations = 25;
  double tolerance = 1e-6;            ///< relative fall of the cost at which it stops
  bool exact = false;                 ///< Jacobians by simulation, not by the linearised motion
  std::vector<double> windowWeights;  ///< one per window, at most 1; empty: all 1
  std::optional<Weights> weights;  ///< another fit's, for squares that compare with its; or else of the start's errors
  std::stop_token stop;
  TimeLimit time;  ///< when it is over, what was come to is the answer
};

/// A window's residual and its derivative by the parameters, as the fit leaves them.
struct WindowDerivative {
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
  Eigen::Index positions = 0;  ///< the first so many rows are positions
};

struct FitResult {
  Model model;                                ///< with 95 % intervals
  std::optional<ParameterVector> parameters;  ///< that x stands for, with the scales of the fit's start; once fitted
  Eigen::VectorXd x;
  Eigen::MatrixXd covariance;  ///< of x; robust against correlation within windows (sandwich by window)
  Weights weights;
  double errors = 0.0;             ///< standard errors that an interval of 95 % reaches each way
  Eigen::VectorXd priorPrecision;  ///< of x; 0 where there is no prior
  std::vector<WindowDerivative> windows;
  std::vector<double> windowSquares;  ///< mean squared position residual per window, m² or rad²
  double currentSquares = 0.0;        ///< mean squared current residual, A²; 0 where no current was recorded
  double rmse = 0.0;
  bool usable = false;
  std::string termination;
};

/// Minimises the weighted residuals over the windows, with a weak prior on the start values of positive quantities (a
/// factor of three, one standard deviation, with the weight of about one window in a hundred), which holds what no data
/// reach: the gauge. Intervals come from the sandwich estimator clustered by stretches of a window's length (H. White,
/// Econometrica 50(1), 1982).
FitResult fitWindows(const ParameterVector& parameters, const std::vector<Track>& tracks,
                     const std::vector<Window>& windows, const FitOptions& options);

/// Mean squared position residual per window with the best initial state, as the fit sees it.
std::vector<double> residualSquares(const Model& model, const std::vector<Track>& tracks,
                                    const std::vector<Window>& windows);

/// Weights that keep single windows from ruling a fit: 1, or less where a window's rms residual exceeds 2.5 times the
/// median's of those windows in which something errs at all.
std::vector<double> robustWeights(const std::vector<double>& windowSquares);

/// Mean squared position residual per window when each window restarts as simulate() does it.
std::vector<double> scoreWindows(const Model& model, const std::vector<Track>& tracks,
                                 const std::vector<Window>& windows);

/// The mean without its largest tenth, which a restart at the edge of standstill may rule.
double typicalSquare(std::vector<double> squares);

}  // namespace breakaway
