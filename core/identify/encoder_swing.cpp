#include "identify/encoder_swing.h"

#include <Eigen/Dense>
#include <cmath>
#include <complex>

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double surelyThere = 20.0;  // gain in χ²

bool shows(const RunSpectrum& run) {
  return run.torque_Nm.size() > 1 && !std::isinf(run.variance_Nm2[1]);
}

}  // namespace

bool EncoderSwing::clear() const {
  return std::norm(wave) > surelyThere * variance;
}

std::optional<EncoderSwing> swingOf(const std::array<WayRuns, 2>& ways) {
  using Normal = Eigen::Matrix<double, 5, 5>;  // C and B of each way, E
  Normal normal = Normal::Zero();
  Eigen::Matrix<Complex, 5, 1> right = Eigen::Matrix<Complex, 5, 1>::Zero();
  for (size_t w = 0; w < 2; ++w) {
    size_t speeds = 0;
    for (size_t j = 0; j < ways[w].spectra.size(); ++j) {
      const RunSpectrum& run = ways[w].spectra[j];
      if (!shows(run) || ways[w].fall[j] > 0.02) continue;
      const double speed = run.speed_rad_per_s, weight = 1.0 / run.variance_Nm2[1];
      Eigen::Matrix<double, 5, 1> row = Eigen::Matrix<double, 5, 1>::Zero();
      const auto own = static_cast<Eigen::Index>(2 * w);
      row[own] = 1.0;
      row[own + 1] = speed;
      row[4] = signOf(Way(w)) * speed * speed;
      normal += weight * row * row.transpose();
      right += (weight * run.torque_Nm[1]) * row.cast<Complex>();
      ++speeds;
    }
    if (speeds < 3) return {};
  }
  const Eigen::Matrix<double, 5, 1> scale = normal.diagonal().cwiseSqrt().cwiseInverse();
  const Normal inverse =
      scale.asDiagonal() * Normal(scale.asDiagonal() * normal * scale.asDiagonal()).inverse() * scale.asDiagonal();
  return EncoderSwing{inverse.row(4).cast<Complex>() * right, inverse(4, 4)};
}

void takeOffEncoderSwing(std::array<WayRuns, 2>& ways, bool certain) {
  const auto swing = swingOf(ways);
  if (!swing || !(certain || swing->clear())) return;
  for (size_t w = 0; w < 2; ++w) {
    for (RunSpectrum& run : ways[w].spectra) {
      if (!shows(run)) continue;
      const double squared = run.speed_rad_per_s * run.speed_rad_per_s;
      run.torque_Nm[1] -= signOf(Way(w)) * squared * swing->wave;
      run.variance_Nm2[1] += squared * squared * swing->variance;
    }
  }
}

}  // namespace breakaway
