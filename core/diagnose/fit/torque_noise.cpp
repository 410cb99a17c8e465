#include "diagnose/fit/torque_noise.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

bool TorqueNoise::usual(double coulomb) const {
  constexpr double most = 0.015, quick_s = 0.3;
  return rms <= most * coulomb / std::sqrt(std::max(1.0, time_s / quick_s));
}

double whiten(const TorqueNoise& noise, double spacing_s, Eigen::Ref<Eigen::MatrixXd> rows) {
  if (noise.ratio <= 0.0) return 0.0;
  const double dt = spacing_s, keep = std::exp(-dt / noise.time_s);
  const double variance = noise.ratio * noise.ratio;
  // Integral, momentum, torque; the torque is taken as constant for one row.
  Eigen::Matrix3d step;
  step << 1.0, dt, 0.5 * dt * dt, 0.0, 1.0, dt, 0.0, 0.0, keep;
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
    state = (step * state).eval();
    covariance = (step * covariance * step.transpose()).eval();
    covariance(2, 2) += variance * (1.0 - keep * keep);
  }
  return logarithms;
}

}  // namespace breakaway
