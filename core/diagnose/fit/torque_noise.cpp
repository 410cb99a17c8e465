#include "diagnose/fit/torque_noise.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr double shortestFriction_s = 0.01;  ///< correlation time of friction that makes a rig a bad one

}  // namespace

double lastingRms(const TorqueNoise& noise) {
  return noise.rms * std::sqrt(std::min(1.0, noise.time_s / shortestFriction_s));
}

double mostWander(double coulomb, double peakTorque, const Criteria& criteria) {
  return criteria.soundPart * (coulomb > 0.0 ? coulomb : peakTorque);
}

double whiten(const TorqueNoise& noise, const Eigen::VectorXd& times, Eigen::Ref<Eigen::MatrixXd> rows,
              const Eigen::VectorXd& impulses) {
  const bool kicked = impulses.size() > 0 && impulses.maxCoeff() > 0.0;
  if (noise.ratio <= 0.0 && !kicked) return 0.0;
  const double variance = noise.ratio * noise.ratio;
  double dt = 0.0, keep = 1.0;
  Eigen::Matrix3d step = Eigen::Matrix3d::Identity();
  // Integral, momentum, torque; the torque is taken as constant for one row.
  const auto stepOver = [&](double length) {
    if (std::abs(length - dt) < 1e-6 * length) return;
    dt = length;
    keep = std::exp(-dt / noise.time_s);
    step << 1.0, dt, 0.5 * dt * dt, 0.0, 1.0, dt, 0.0, 0.0, keep;
  };
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance(2, 2) = variance;
  Eigen::Matrix3Xd state = Eigen::Matrix3Xd::Zero(3, rows.cols());
  double logarithms = 0.0;
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    const double innovation = 1.0 + covariance(0, 0);
    const Eigen::Vector3d gain = covariance.col(0) * (1.0 / innovation);
    const Eigen::RowVectorXd off = rows.row(r) - state.row(0);
    state += gain * off;
    covariance -= gain * covariance.row(0).eval();
    rows.row(r) = off / std::sqrt(innovation);
    logarithms += 0.5 * std::log(innovation);
    if (r + 1 == rows.rows()) break;
    stepOver(times[r + 1] - times[r]);
    if (kicked) covariance(1, 1) += impulses[r + 1];
    state = (step * state).eval();
    covariance = (step * covariance * step.transpose()).eval();
    covariance(2, 2) += variance * (1.0 - keep * keep);
  }
  return logarithms;
}

}  // namespace breakaway
