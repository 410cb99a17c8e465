#include "trial/trial_sizing.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

using Eigen::VectorXd;

constexpr double window_s = 0.5;
constexpr size_t windows = 30, points = 10;  // of one comparison

/// The rig's base physics with log factors on inertia, viscous friction, Coulomb friction and resistance.
PlantPhysics basePhysics(const TrialRig& rig, const VectorXd& logs) {
  const PlantPhysics& p = rig.physics;
  TrialRig plain;
  plain.setFriction(rig.coulomb() * std::exp(logs[2]), rig.viscous() * std::exp(logs[1]));
  PlantPhysics base = plain.physics;
  base.electrical = p.electrical;
  base.torqueConstant = p.torqueConstant;
  base.backEmfConstant = p.backEmfConstant;
  base.inductance_H = p.inductance_H;
  base.inertia = p.totalInertia() * std::exp(logs[0]);
  if (rig.pendulum) base.position.push_back(weightOf(*rig.pendulum));
  base.resistance_ohm = p.resistance_ohm * (p.electrical ? std::exp(logs[3]) : 1.0);
  return base;
}

/// Position errors at the points of all windows, in counts.
VectorXd errors(const TrialRig& rig, const TrialTrace& trace, const VectorXd& logs) {
  constexpr double step_s = 50e-6;
  const double row_s = rig.sensors.row_s;
  const auto length = static_cast<size_t>(window_s / row_s);
  const int perRow = std::max(1, static_cast<int>(std::lround(row_s / step_s)));
  Plant plant(basePhysics(rig, logs), row_s / perRow, 1);
  VectorXd out(static_cast<Eigen::Index>(windows * points));
  Eigen::Index at = 0;
  for (size_t w = 0; w < windows; ++w) {
    const size_t first = 1 + w * (trace.position.size() - length - 2) / (windows - 1);
    const double speed = (trace.position[first + 1] - trace.position[first - 1]) / (2.0 * row_s);
    plant.set(trace.position[first], speed, trace.current[first]);
    for (size_t k = 0; k < length; ++k) {
      plant.apply(trace.input[first + k]);
      plant.advance(perRow);
      if ((k + 1) % (length / points) == 0 && at < static_cast<Eigen::Index>((w + 1) * points)) {
        out[at++] = (plant.angle_rad() - trace.position[first + k + 1]) / rig.sensors.count;
      }
    }
  }
  return out;
}

}  // namespace

double costOfLeavingOut(const TrialRig& rig, const TrialTrace& trace) {
  const Eigen::Index unknowns = rig.electrical() ? 4 : 3;
  VectorXd logs = VectorXd::Zero(unknowns);
  VectorXd error = errors(rig, trace, logs);
  for (int round = 0; round < 3; ++round) {
    Eigen::MatrixXd slopes(error.size(), unknowns);  // of the errors over the logs
    for (Eigen::Index j = 0; j < unknowns; ++j) {
      VectorXd moved = logs;
      moved[j] += 0.02;
      slopes.col(j) = (errors(rig, trace, moved) - error) / 0.02;
    }
    Eigen::MatrixXd normal = slopes.transpose() * slopes;
    normal.diagonal() *= 1.001;
    VectorXd change = -solveSymmetric(normal, slopes.transpose() * error);
    change = change.cwiseMax(-0.5).cwiseMin(0.5);
    bool better = false;
    for (int shorter = 0; shorter < 3 && !better; ++shorter, change *= 0.35) {
      const VectorXd next = logs + change;
      const VectorXd tried = errors(rig, trace, next);
      better = tried.squaredNorm() < error.squaredNorm();
      if (!better) continue;
      const bool done = tried.squaredNorm() > 0.98 * error.squaredNorm();
      logs = next;
      error = tried;
      if (done) round = 3;
    }
    if (!better) break;
  }
  return std::sqrt(error.squaredNorm() / static_cast<double>(error.size())) * rig.sensors.count / sensorFloor(rig);
}

double sensorFloor(const TrialRig& rig) {
  const PlantPhysics& p = rig.physics;
  const double encoder = 1.2 * rig.sensors.count, J = p.totalInertia();
  // White torque noise of deviation s, held for dt: position error over 0 … T has rms s/J √dt √(T³/12).
  const double integrated = std::sqrt(window_s * window_s * window_s / 12.0) / J;
  const double drive = rig.input == DriveInput::current
                           ? rig.sensors.currentNoise_A * p.torqueConstant * std::sqrt(rig.sensors.row_s) * integrated
                           : 0.0;
  const double process = p.outside.noise * std::sqrt(1e-3) * integrated;
  return std::hypot(encoder, drive, process);
}

}  // namespace breakaway
