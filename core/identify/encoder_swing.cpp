#include "identify/encoder_swing.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "dense/dense_solve.h"
#include "identify/encoder_disc.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double surelyThere = 20.0;                // gain in χ²
constexpr size_t leastSpeeds = 3, swingOrders = 3;  // e's own, and those of its square and cube
constexpr Eigen::Index unknowns = 5;                // C and B of each way, E

/// The larger of the waves that this order's torque is left of.
double largerWave(const RunSpectrum& run, size_t order, double inertia_kg_m2, const EncoderDisc& disc) {
  const double square = run.speed_rad_per_s * run.speed_rad_per_s;
  return inertia_kg_m2 * std::max(std::abs(run.acceleration_rad_per_s2[order]),
                                  square * std::pow(std::abs(disc.off_rad), static_cast<double>(order)));
}

/// With the acceleration, as which an inertia that is off shows.
struct SwingRow {
  Eigen::Matrix<Complex, unknowns + 1, 1> regressors = Eigen::Matrix<Complex, unknowns + 1, 1>::Zero();
  Complex torque_Nm;
  double variance_Nm2, wave_Nm;
};

std::vector<SwingRow> swingRows(const std::array<WayRuns, 2>& ways, size_t order, double inertia_kg_m2,
                                const EncoderDisc& disc) {
  std::vector<SwingRow> rows;
  for (size_t w = 0; w < 2; ++w) {
    for (size_t j = 0; j < ways[w].spectra.size(); ++j) {
      const RunSpectrum& run = ways[w].spectra[j];
      if (!shows(run, order) || ways[w].fall[j] > 0.02) continue;
      SwingRow row{{}, run.torque_Nm[order], run.variance_Nm2[order], largerWave(run, order, inertia_kg_m2, disc)};
      row.regressors.setZero();
      const auto own = static_cast<Eigen::Index>(2 * w);
      row.regressors[own] = 1.0;
      row.regressors[own + 1] = run.speed_rad_per_s;
      row.regressors[unknowns - 1] = signOf(Way(w)) * run.speed_rad_per_s * run.speed_rad_per_s;
      row.regressors[unknowns] = inertia_kg_m2 * run.acceleration_rad_per_s2[order];
      rows.push_back(row);
    }
  }
  return rows;
}

/// Of the residuals, each over its variance with ρ²·w².
double squaresWith(const std::vector<SwingRow>& rows, double part) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXcd A(n, unknowns + 1);
  Eigen::VectorXcd y(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const SwingRow& row = rows[static_cast<size_t>(k)];
    const double root = 1.0 / std::hypot(std::sqrt(row.variance_Nm2), part * row.wave_Nm);
    A.row(k) = root * row.regressors.transpose();
    y[k] = root * row.torque_Nm;
  }
  for (Eigen::Index c = 0; c <= unknowns; ++c) {
    const double size = A.col(c).norm();
    if (size > 0.0) A.col(c) /= size;
  }
  return (y - A * A.colPivHouseholderQr().solve(y)).squaredNorm();
}

}  // namespace

bool EncoderSwing::clear() const {
  return std::norm(wave) > surelyThere * variance;
}

std::optional<EncoderSwing> swingOf(const std::array<WayRuns, 2>& ways) {
  using Normal = Eigen::Matrix<double, unknowns, unknowns>;
  using Column = Eigen::Matrix<double, unknowns, 1>;
  Normal normal = Normal::Zero();
  Eigen::Matrix<Complex, unknowns, 1> right = Eigen::Matrix<Complex, unknowns, 1>::Zero();
  for (size_t w = 0; w < 2; ++w) {
    const auto own = static_cast<Eigen::Index>(2 * w);
    const auto rows = lineRows(ways[w], 1, fitOrder(ways[w], 1, true).coulomb);
    if (rows.size() < leastSpeeds) return {};
    for (const LineRow& one : rows) {
      Column row = Column::Zero();
      row.segment<2>(own) = one.regressors;
      row[unknowns - 1] = signOf(Way(w)) * one.speed_rad_per_s * one.speed_rad_per_s;
      normal += one.weight * row * row.transpose();
      right += (one.weight * one.torque_Nm) * row.cast<Complex>();
    }
  }
  const Column scale = normal.diagonal().cwiseSqrt().cwiseInverse();
  const Normal inverse =
      scale.asDiagonal() * Normal(inverseOf(scale.asDiagonal() * normal * scale.asDiagonal())) * scale.asDiagonal();
  const Eigen::Matrix<Complex, unknowns, 1> x = inverse.cast<Complex>() * right;
  EncoderSwing swing{x[unknowns - 1], inverse(unknowns - 1, unknowns - 1), {}};
  for (Eigen::Index w = 0; w < 2; ++w) {
    FrictionLine& line = swing.lines[static_cast<size_t>(w)];
    line.coulomb = x[2 * w];
    line.viscous = x[2 * w + 1];
    line.coulombVariance = inverse(2 * w, 2 * w);
    line.viscousVariance = inverse(2 * w + 1, 2 * w + 1);
    line.covariance = inverse(2 * w, 2 * w + 1);
  }
  return swing;
}

bool takeOffEncoderSwing(std::array<WayRuns, 2>& ways, bool certain) {
  const auto swing = swingOf(ways);
  if (!swing || !(certain || swing->clear())) return false;
  for (size_t w = 0; w < 2; ++w) {
    for (RunSpectrum& run : ways[w].spectra) {
      if (shows(run, 1)) run.torque_Nm[1] -= signOf(Way(w)) * run.speed_rad_per_s * run.speed_rad_per_s * swing->wave;
    }
  }
  return true;
}

void widenBySwing(std::array<WayRuns, 2>& ways, double inertia_kg_m2, const EncoderDisc& disc) {
  for (size_t order = 1; order <= swingOrders; ++order) {
    const auto rows = swingRows(ways, order, inertia_kg_m2, disc);
    const double spare = 2.0 * (static_cast<double>(rows.size()) - static_cast<double>(unknowns + 1));
    if (spare <= 0.0 || squaresWith(rows, 0.0) <= spare) continue;
    double low = 1e-9, high = 1.0;
    for (int k = 0; k < 40; ++k) {
      const double middle = std::sqrt(low * high);
      (squaresWith(rows, middle) > spare ? low : high) = middle;
    }
    for (WayRuns& way : ways) {
      for (RunSpectrum& run : way.spectra) {
        if (!shows(run, order)) continue;
        const double off_Nm = high * largerWave(run, order, inertia_kg_m2, disc);
        run.variance_Nm2[order] += off_Nm * off_Nm;
      }
    }
  }
}

}  // namespace breakaway
