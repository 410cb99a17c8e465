// How exact a friction map can be: the Cramér–Rao bound of a rig's sensors in the rig time that was used.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "friction/friction_map.h"
#include "friction/measurements.h"
#include "plant/rig.h"

namespace breakaway::test {

/// Least RMS error over the bins of one way, in Nm and Nm s/rad.
struct WayBound {
  double static_Nm = 0.0, coulomb_Nm = 0.0, viscous_Nm_s_per_rad = 0.0;
};

/// Of one sample of the current: the sensor's noise, and the converter's step as a uniform error.
inline double currentVariance_A2(const Rig& rig) {
  const RigCurrentSensor& sensor = rig.currentSensor;
  const double step_A = sensor.adcRange_V / std::exp2(sensor.adcBits) / sensor.sensitivity_V_per_A;
  return sensor.noiseRms_A * sensor.noiseRms_A + step_A * step_A / 12.0;
}

inline int highestOf(const std::vector<Harmonic>& harmonics, int atLeast = 0) {
  for (const Harmonic& one : harmonics) atLeast = std::max(atLeast, static_cast<int>(one.order));
  return atLeast;
}

/// The mean of both ways' lines and the sensor's zero, jointly: per way C and B, and the zero as a line over time. The
/// runs say Kt·i = C + B·|ω| ± Kt·zero(t), the zeroings before each of them and after the last zero(t). Returns the
/// covariance of C_cw, B_cw, C_ccw, B_ccw.
inline Eigen::Matrix4d meanCovariance(const Rig& rig, const std::vector<VelocityRun>& runs, double zeroing_s) {
  const double Kt = rig.torqueConstant_Nm_per_A, perSample = currentVariance_A2(rig);
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  double speedScale = 1.0, whole_s = 0.0, now_s = 0.0;
  for (const VelocityRun& run : runs) {
    speedScale = std::max(speedScale, std::abs(run.target_rad_per_s));
    whole_s += zeroing_s + run.duration_s;
  }
  const auto add = [&information](const Eigen::Matrix<double, 6, 1>& row, double variance) {
    information += row * row.transpose() / variance;
  };
  const auto zeroAt = [&](double time_s) {
    add((Eigen::Matrix<double, 6, 1>() << 0, 0, 0, 0, Kt, Kt * time_s / whole_s).finished(),
        Kt * Kt * perSample / (zeroing_s * rig.loopRate_Hz));
  };
  for (const VelocityRun& run : runs) {
    zeroAt(now_s + 0.5 * zeroing_s);
    now_s += zeroing_s;
    const double sign = run.way() == Way::ccw ? 1.0 : -1.0, middle = (now_s + 0.5 * run.duration_s) / whole_s;
    Eigen::Matrix<double, 6, 1> row = Eigen::Matrix<double, 6, 1>::Zero();
    const auto w = static_cast<Eigen::Index>(run.way());
    row[2 * w] = 1.0;
    row[2 * w + 1] = std::abs(run.target_rad_per_s) / speedScale;
    row[4] = sign * Kt;
    row[5] = sign * Kt * middle;
    add(row, Kt * Kt * perSample / (run.duration_s * rig.loopRate_Hz));
    now_s += run.duration_s;
  }
  zeroAt(now_s);
  Eigen::Matrix4d covariance = information.inverse().topLeftCorner<4, 4>();
  for (const Eigen::Index k : {1, 3}) {
    covariance.row(k) /= speedScale;
    covariance.col(k) /= speedScale;
  }
  return covariance;
}

/// Cramér–Rao bound of the moving map of one way from the speeds that were run, no prior knowledge but the highest
/// orders of the rig's Coulomb (with position torque) and viscous curves: 2K + 1 parameters each. A harmonic's torque
/// in one run of N samples is known to 2/N·(Kt²·σ_i² + J²·(kω)⁴·q²/12) in each component, q the encoder's count: the
/// current's noise and what the encoder's rounding leaves of the acceleration.
inline void boundMoving(const Rig& rig, const std::vector<VelocityRun>& runs, Way way, double zeroing_s,
                        WayBound& bound) {
  const auto w = static_cast<size_t>(way);
  const double Kt = rig.torqueConstant_Nm_per_A, J = rig.inertia_kg_m2;
  const double count = 2.0 * std::numbers::pi / rig.encoder.countsPerRev;
  const int coulombOrder = highestOf(rig.coulomb_Nm[w].harmonics, highestOf(rig.positionTorque_Nm));
  const int viscousOrder = highestOf(rig.viscous_Nm_s_per_rad[w].harmonics);
  const Eigen::Matrix4d mean = meanCovariance(rig, runs, zeroing_s);
  const auto c = static_cast<Eigen::Index>(2 * w);
  double coulomb = mean(c, c), viscous = mean(c + 1, c + 1);
  for (int order = 1; order <= std::max(coulombOrder, viscousOrder); ++order) {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    for (const VelocityRun& run : runs) {
      if (run.way() != way) continue;
      const double speed = std::abs(run.target_rad_per_s), samples = run.duration_s * rig.loopRate_Hz;
      const double inertial = J * std::pow(order * speed, 2);
      const double variance =
          2.0 / samples * (Kt * Kt * currentVariance_A2(rig) + inertial * inertial * count * count / 12.0);
      const Eigen::Vector2d row(order <= coulombOrder ? 1.0 : 0.0, order <= viscousOrder ? speed : 0.0);
      information += row * row.transpose() / variance;
    }
    if (order <= coulombOrder && order <= viscousOrder) {
      const Eigen::Matrix2d covariance = information.inverse();
      coulomb += covariance(0, 0);
      viscous += covariance(1, 1);
    } else if (order <= coulombOrder) {
      coulomb += 1.0 / information(0, 0);
    } else {
      viscous += 1.0 / information(1, 1);
    }
  }
  bound.coulomb_Nm = std::sqrt(coulomb);
  bound.viscous_Nm_s_per_rad = std::sqrt(viscous);
}

/// Bound of the breakaway map: the scatter of M breakaways and the current's noise over their ramps go into the 2K + 1
/// parameters of the curve; the zeroings' noise goes into the mean alone.
inline double boundStatic(const Rig& rig, const std::vector<BreakawayEvent>& events, Way way, double zeroingSamples) {
  const auto w = static_cast<size_t>(way);
  const int order = highestOf(rig.staticFriction_Nm[w].harmonics, highestOf(rig.positionTorque_Nm));
  const PlantPhysics physics = physicsOf(rig);
  double count = 0.0, samples = 0.0, squares = 0.0;
  for (const BreakawayEvent& event : events) {
    if (event.way != way) continue;
    count += 1.0;
    samples += static_cast<double>(event.samples);
    squares += std::pow(rig.scatterRms * torquesAt(physics, event.angle_rad).static_Nm[w], 2);
  }
  if (count == 0.0) return 0.0;
  const double Kt = rig.torqueConstant_Nm_per_A, parameters = 2.0 * order + 1.0;
  const double sensor =
      Kt * Kt * currentVariance_A2(rig) * (parameters / samples + 1.0 / std::max(1.0, zeroingSamples));
  return std::sqrt(parameters * squares / (count * count) + sensor);
}

}  // namespace breakaway::test
