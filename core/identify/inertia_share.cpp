#include "identify/inertia_share.h"

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
// The noise of the acceleration is in the torque as well, with the opposite sign: what is in the noise would tell −J.
constexpr double standsOut = 25.0;         // standard errors of the torque
constexpr Eigen::Index shareUnknowns = 5;  // C and B of each way, the encoder's wave

struct ShareRow {
  Eigen::Matrix<double, shareUnknowns, 1> regressors = Eigen::Matrix<double, shareUnknowns, 1>::Zero();
  Complex torque, acceleration;
  double weight;
};

/// Of one order, both ways; empty where no run accelerates clearly.
std::vector<ShareRow> rowsOf(const std::array<WayRuns, 2>& ways, size_t order, double inertia_kg_m2) {
  std::vector<ShareRow> rows;
  bool clear = false;
  for (size_t w = 0; w < 2; ++w) {
    for (size_t j = 0; j < ways[w].spectra.size(); ++j) {
      const RunSpectrum& run = ways[w].spectra[j];
      if (!shows(run, order) || ways[w].fall[j] > 0.02) continue;
      ShareRow row{{}, run.torque_Nm[order], run.acceleration_rad_per_s2[order], 1.0 / run.variance_Nm2[order]};
      row.regressors.setZero();
      const auto own = static_cast<Eigen::Index>(2 * w);
      row.regressors[own] = 1.0;
      row.regressors[own + 1] = run.speed_rad_per_s;
      if (order == 1) row.regressors[4] = signOf(Way(w)) * run.speed_rad_per_s * run.speed_rad_per_s;
      clear = clear || inertia_kg_m2 * std::abs(row.acceleration) > standsOut * std::sqrt(run.variance_Nm2[order]);
      rows.push_back(row);
    }
  }
  if (!clear) rows.clear();
  return rows;
}

/// The rows' share in the information about −ΔJ and in its right side, freed of the other unknowns.
void addOrder(const std::vector<ShareRow>& rows, double& information, double& right) {
  using Normal = Eigen::Matrix<double, shareUnknowns, shareUnknowns>;
  Normal normal = Normal::Zero();
  Eigen::Matrix<Complex, shareUnknowns, 1> torques = Eigen::Matrix<Complex, shareUnknowns, 1>::Zero(),
                                           accelerations = torques;
  for (const ShareRow& row : rows) {
    normal += row.weight * row.regressors * row.regressors.transpose();
    torques += (row.weight * row.torque) * row.regressors.cast<Complex>();
    accelerations += (row.weight * row.acceleration) * row.regressors.cast<Complex>();
  }
  const Eigen::Matrix<double, shareUnknowns, 1> scale =
      normal.diagonal().unaryExpr([](double x) { return x > 0.0 ? 1.0 / std::sqrt(x) : 0.0; });
  const Normal inverse =
      scale.asDiagonal() * Normal(pseudoInverse(scale.asDiagonal() * normal * scale.asDiagonal())) * scale.asDiagonal();
  const Eigen::Matrix<Complex, shareUnknowns, 1> t = inverse.cast<Complex>() * torques,
                                                 a = inverse.cast<Complex>() * accelerations;
  for (const ShareRow& row : rows) {
    const Complex torque = row.torque - (row.regressors.cast<Complex>().transpose() * t)(0);
    const Complex acceleration = row.acceleration - (row.regressors.cast<Complex>().transpose() * a)(0);
    information += row.weight * std::norm(acceleration);
    right += row.weight * (std::conj(acceleration) * torque).real();
  }
}

}  // namespace

void freeOfInertia(std::array<WayRuns, 2>& ways, double inertia_kg_m2, double inertiaError_kg_m2) {
  if (!(inertiaError_kg_m2 > 0.0)) return;
  double information = 1.0 / (inertiaError_kg_m2 * inertiaError_kg_m2), right = 0.0;
  size_t orders = 0;
  for (const WayRuns& way : ways) {
    for (const RunSpectrum& run : way.spectra) orders = std::max(orders, run.torque_Nm.size());
  }
  for (size_t order = 1; order < orders; ++order) addOrder(rowsOf(ways, order, inertia_kg_m2), information, right);
  const double off = right / information, variance = 1.0 / information;
  for (WayRuns& way : ways) {
    for (RunSpectrum& run : way.spectra) {
      for (size_t order = 1; order < run.torque_Nm.size(); ++order) {
        if (!shows(run, order)) continue;
        run.torque_Nm[order] -= off * run.acceleration_rad_per_s2[order];
        run.variance_Nm2[order] += 0.5 * variance * std::norm(run.acceleration_rad_per_s2[order]);
      }
    }
  }
}

}  // namespace breakaway
