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

FrequencyResponse::FrequencyResponse(const DiscreteSystem& system, Eigen::Index from, Eigen::Index to)
    : tick_s_(system.tick_s),
      direct_(system.D(to, from)),
      start_(-system.A.cast<std::complex<double>>()),
      b_(system.B.col(from).cast<std::complex<double>>()),
      c_(system.C.row(to).cast<std::complex<double>>()) {
  if (system.A.rows() > 1) {
    const Eigen::HessenbergDecomposition<Eigen::MatrixXd> reduced(system.A);
    const Eigen::MatrixXd Q = reduced.matrixQ();
    start_ = -Eigen::MatrixXd(reduced.matrixH()).cast<std::complex<double>>();
    b_ = (Q.transpose() * b_).eval();
    c_ = (c_ * Q).eval();
  }
  pencil_ = start_;
  x_ = b_;
}

/// (zI − H)·x = b by elimination with the larger of two neighbouring rows as pivot.
std::complex<double> FrequencyResponse::operator()(double frequency_rad_per_s) {
  pencil_ = start_;
  pencil_.diagonal().array() += std::polar(1.0, frequency_rad_per_s * tick_s_);
  x_ = b_;
  const Eigen::Index n = pencil_.rows();
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    if (std::norm(pencil_(k + 1, k)) > std::norm(pencil_(k, k))) {
      pencil_.row(k).tail(n - k).swap(pencil_.row(k + 1).tail(n - k));
      std::swap(x_[k], x_[k + 1]);
    }
    const std::complex<double> factor = pencil_(k + 1, k) / pencil_(k, k);
    pencil_.row(k + 1).tail(n - k - 1) -= factor * pencil_.row(k).tail(n - k - 1);
    x_[k + 1] -= factor * x_[k];
  }
  pencil_.triangularView<Eigen::Upper>().solveInPlace(x_);
  return (c_ * x_).value() + direct_;
}

std::vector<std::complex<double>> response(const DiscreteSystem& system, Eigen::Index from, Eigen::Index to,
                                           const std::vector<double>& frequencies_rad_per_s) {
  FrequencyResponse at(system, from, to);
  std::vector<std::complex<double>> answer;
  answer.reserve(frequencies_rad_per_s.size());
  for (const double frequency : frequencies_rad_per_s) answer.push_back(at(frequency));
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
