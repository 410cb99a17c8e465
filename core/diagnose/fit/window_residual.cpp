#include "diagnose/fit/window_residual.h"

#include <Eigen/Dense>
#include <cmath>

#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/restart.h"

namespace breakaway {

std::vector<Window> windowsOf(const std::vector<Track>& tracks, size_t track, size_t from, size_t to, double window_s) {
  std::vector<Window> windows;
  std::vector<size_t> starts = restartRows(tracks[track], window_s);
  const auto& time = tracks[track].time;
  // The last window counts only when it is nearly whole.
  if (time.back() - time[starts.back()] >= window_s * 0.9) starts.push_back(time.size());
  for (size_t k = 0; k + 1 < starts.size(); ++k) {
    if (starts[k] < from || starts[k + 1] > to || starts[k + 1] - starts[k] < 8) continue;
    windows.push_back({track, starts[k], starts[k + 1] - 1});
  }
  return windows;
}

WindowResidual::WindowResidual(const Track& track, const Window& window, Weights weights)
    : track_(track), window_(window), weights_(weights), length_(track.time[window.last] - track.time[window.first]) {
  for (size_t k = window.first; k <= window.last; ++k) {
    positions_ += track.seen[k] ? 1 : 0;
    currents_ += weights.current > 0.0 && k > window.first && useCurrent(k) ? 1 : 0;
  }
}

bool WindowResidual::useCurrent(size_t row) const {
  return !track_.current.empty() && track_.connected[row] != 0 && std::isfinite(track_.current[row]);
}

void WindowResidual::simulate(Stepper& stepper, MotionState state, Eigen::VectorXd& out) const {
  state.current = observed_.current;  // what the voltages before the window have left
  Eigen::Index position = 0, current = positions_;
  for (size_t k = window_.first;; ++k) {
    if (track_.seen[k]) out[position++] = weights_.position * (state.position - track_.position[k]);
    if (currents_ > 0 && k > window_.first && useCurrent(k)) {
      out[current++] = weights_.current * (state.current - track_.current[k]);
    }
    if (k == window_.last) break;
    run(stepper, track_, k, k + 1, state);
  }
}

void WindowResidual::evaluate(Stepper& stepper, const MotionState& from, Eigen::VectorXd& out) const {
  simulate(stepper, from, out);
  out[rows() - 2] = xFirm_ * (from.position - observed_.position);
  out[rows() - 1] = vFirm_ * (from.velocity - observed_.velocity);
}

void WindowResidual::fit(const Model& model) {
  Stepper stepper(physicsOf(model), *termsOf(model));
  observed_ = restartState(stepper, track_, window_.first, model.restartHorizon_s);
  state_ = observed_;
  // The residuals of a window are correlated: they count as about three independent ones, and the state's doubt is
  // weighed alike.
  const double firmness = std::sqrt(static_cast<double>(positions_) / 3.0);
  xFirm_ = firmness / std::max(track_.noise, 1e-12);
  vFirm_ = firmness / std::max(restartVelocityNoise(track_, model.restartHorizon_s), 1e-12);
  nominal_.resize(rows());
  Eigen::VectorXd moved(rows());
  Eigen::MatrixXd byState(rows(), 2);
  const double shift = std::max(track_.noise, 1e-9 * length_), kick = shift / length_;
  evaluate(stepper, state_, nominal_);
  evaluate(stepper, {state_.position + shift, state_.velocity, 0.0}, moved);
  byState.col(0) = (moved - nominal_) / shift;
  evaluate(stepper, {state_.position, state_.velocity + kick, 0.0}, moved);
  byState.col(1) = (moved - nominal_) / kick;
  // The observer is close and the motion nearly linear in its start: one step is enough, and a worse one is taken back.
  const Eigen::Vector2d step = (byState.transpose() * byState).ldlt().solve(-byState.transpose() * nominal_);
  evaluate(stepper, {state_.position + step[0], state_.velocity + step[1], 0.0}, moved);
  if (moved.squaredNorm() < nominal_.squaredNorm()) {
    nominal_ = moved;
    state_.position += step[0];
    state_.velocity += step[1];
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(byState);
  basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(rows(), 2);
  residual_ = nominal_ - basis_ * (basis_.transpose() * nominal_);
}

Eigen::VectorXd WindowResidual::column(const Model& variant, double step) const {
  Stepper stepper(physicsOf(variant), *termsOf(variant));
  Eigen::VectorXd moved(rows());
  evaluate(stepper, state_, moved);
  moved = (moved - nominal_) / step;
  return moved - basis_ * (basis_.transpose() * moved);
}

Weights weightsAt(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows) {
  double position = 0.0, current = 0.0, positions = 0.0, currents = 0.0, noise = 1e-12;
  for (const Window& window : windows) {
    WindowResidual residual(tracks[window.track], window, {1.0, 1.0});
    residual.fit(model);
    position += residual.residual().head(residual.positions()).squaredNorm();
    current += residual.residual().segment(residual.positions(), residual.currents()).squaredNorm();
    positions += static_cast<double>(residual.positions());
    currents += static_cast<double>(residual.currents());
    noise = std::max(noise, tracks[window.track].noise);
  }
  Weights weights;
  weights.position = 1.0 / std::max(std::sqrt(position / std::max(positions, 1.0)), noise);
  if (currents > 0.0) weights.current = 1.0 / std::max(std::sqrt(current / currents), 1e-9);
  return weights;
}

}  // namespace breakaway
