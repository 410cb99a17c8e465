#include "stability/discrete_system.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

/// Scales states by powers of two until rows and columns are of a size, which eigenvalues don't feel but their
/// rounding does. Source: Parlett, Reinsch, "Balancing a matrix", Numer. Math. 13, 1969.
Eigen::MatrixXd balanced(Eigen::MatrixXd A) {
  for (int round = 0; round < 20; ++round) {
    bool settled = true;
    for (Eigen::Index k = 0; k < A.rows(); ++k) {
      const double column = A.col(k).cwiseAbs().sum() - std::abs(A(k, k));
      const double row = A.row(k).cwiseAbs().sum() - std::abs(A(k, k));
      if (!(column > 0.0) || !(row > 0.0)) continue;
      const double scale = std::exp2(std::round(0.5 * std::log2(row / column)));
      if (scale == 1.0) continue;
      A.col(k) *= scale;
      A.row(k) /= scale;
      settled = false;
    }
    if (settled) break;
  }
  return A;
}

}  // namespace

std::vector<std::complex<double>> poles(const DiscreteSystem& system) {
  const Eigen::VectorXcd values = balanced(system.A).eigenvalues();
  std::vector<std::complex<double>> all(values.begin(), values.end());
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::abs(a) != std::abs(b) ? std::abs(a) > std::abs(b) : a.imag() > b.imag();
  });
  return all;
}

double spectralRadius(const DiscreteSystem& system) {
  return system.A.size() == 0 ? 0.0 : balanced(system.A).eigenvalues().cwiseAbs().maxCoeff();
}

double damping(const std::vector<std::complex<double>>& poles) {
  double least = 1.0;
  for (const std::complex<double>& z : poles) {
    if (std::abs(z) <= std::exp(-1.0)) continue;
    const std::complex<double> s = std::log(z);
    if (std::abs(s) > 0.0) least = std::min(least, -s.real() / std::abs(s));
  }
  return least;
}

std::vector<std::complex<double>> response(const DiscreteSystem& system, Eigen::Index from, Eigen::Index to,
                                           const std::vector<double>& frequencies_rad_per_s) {
  const Eigen::VectorXcd b = system.B.col(from).cast<std::complex<double>>();
  const Eigen::RowVectorXcd c = system.C.row(to).cast<std::complex<double>>();
  Eigen::MatrixXcd pencil = -system.A.cast<std::complex<double>>();
  std::vector<std::complex<double>> answer;
  answer.reserve(frequencies_rad_per_s.size());
  for (const double frequency : frequencies_rad_per_s) {
    const std::complex<double> z = std::polar(1.0, frequency * system.tick_s);
    pencil.diagonal() = -system.A.diagonal().cast<std::complex<double>>().array() + z;
    answer.push_back((c * pencil.partialPivLu().solve(b)).value() + system.D(to, from));
  }
  return answer;
}

Result<Eigen::MatrixXd> stationaryCovariance(const DiscreteSystem& system, const Eigen::VectorXd& variances) {
  if (const double radius = spectralRadius(system); !(radius < 1.0))
    return Error{"loop", "is not stable (a pole of magnitude " + std::to_string(radius) + "), so its noise grows"};
  Eigen::MatrixXd P = system.B * variances.asDiagonal() * system.B.transpose(), A = system.A;
  for (int doubling = 0; doubling < 64; ++doubling) {
    const Eigen::MatrixXd more = A * P * A.transpose();
    P += more;
    if (more.norm() <= 1e-14 * P.norm()) break;
    A = (A * A).eval();
  }
  return P;
}

Result<Eigen::VectorXd> stationaryRms(const DiscreteSystem& system, const Eigen::VectorXd& variances) {
  const auto P = stationaryCovariance(system, variances);
  if (!P) return P.error();
  const Eigen::MatrixXd Y =
      system.C * *P * system.C.transpose() + system.D * variances.asDiagonal() * system.D.transpose();
  return Eigen::VectorXd(Y.diagonal().cwiseMax(0.0).cwiseSqrt());
}

}  // namespace breakaway
