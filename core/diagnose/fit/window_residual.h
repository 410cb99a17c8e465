// One restarted window's residuals, their initial state eliminated: what the fit minimises and the score test looks at.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/fit/parameter_vector.h"
#include "diagnose/simulate/stepper.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// Rows [first, last] of one track.
struct Window {
  size_t track = 0;
  size_t first = 0;
  size_t last = 0;
  bool operator==(const Window&) const = default;
};

/// The windows of a track that begin at restartRows() and lie wholly within rows [from, to); windows of fewer than 8
/// rows are left out.
std::vector<Window> windowsOf(const std::vector<Track>& tracks, size_t track, size_t from, size_t to, double window_s);

/// How the residuals of each channel are weighed: one over a typical residual.
struct Weights {
  double position = 1.0;
  double current = 0.0;
};

/// Residuals of positions (and of currents where the track has them). The window's initial position and velocity are
/// free, held to what the restart's observer saw as firmly as its noise allows, and eliminated by variable projection
/// (G. Golub, V. Pereyra, SIAM J. Numer. Anal. 10(2), 1973).
class WindowResidual {
 public:
  WindowResidual(const Track& track, const Window& window, Weights weights);

  /// Positions first, then currents, then two rows for the state.
  Eigen::Index rows() const { return positions_ + currents_ + 2; }
  Eigen::Index positions() const { return positions_; }
  Eigen::Index currents() const { return currents_; }

  /// The weighted residuals of `model`, with the best initial state. Then columns(): the change of the residuals per
  /// unit of a variant, (variant − model)/step, with the initial state's share taken out.
  void fit(const Model& model);
  const Eigen::VectorXd& residual() const { return residual_; }
  Eigen::VectorXd column(const Model& variant, double step) const;

 private:
  bool useCurrent(size_t row) const;
  void simulate(Stepper& stepper, MotionState state, Eigen::VectorXd& out) const;
  void evaluate(Stepper& stepper, const MotionState& from, Eigen::VectorXd& out) const;

  const Track& track_;
  Window window_;
  Weights weights_;
  double length_ = 0.0;
  Eigen::Index positions_ = 0, currents_ = 0;
  MotionState observed_, state_;
  double xFirm_ = 0.0, vFirm_ = 0.0;
  Eigen::VectorXd nominal_, residual_;
  Eigen::MatrixXd basis_;
};

/// Weights at `model`: one over the root mean square of each channel's residual.
Weights weightsAt(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows);

}  // namespace breakaway
