#include "diagnose/fit/excitation_seen.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/fit/motion.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

Excitation excitationOf(const std::vector<Track>& tracks, const Model& model) {
  Excitation seen;
  seen.axis = model.axis;
  seen.count = model.count;
  const Physics physics = physicsOf(model);
  seen.inertia = physics.inertia;
  seen.coulomb = physics.coulomb;
  seen.byReference = model.servo.has_value();
  seen.electrical = physics.electrical;
  seen.currentDrive = model.input == DriveInput::current && !seen.byReference;
  seen.driveMeasured = seen.currentDrive && std::all_of(tracks.begin(), tracks.end(),
                                                        [](const Track& track) { return track.inputNoise > 0.0; });
  seen.currentSeen = physics.electrical && std::all_of(tracks.begin(), tracks.end(),
                                                       [](const Track& track) { return !track.current.empty(); });
  seen.supply_V = tracks.front().supplyAt(0);
  seen.supplySeen = model.supply_V.value_or(0.0) > 0.0 || !tracks.front().supply.empty();
  seen.step_s = tracks.front().time.back() / static_cast<double>(tracks.front().rows() - 1);
  std::vector<double> speeds, torques, currents, accelerations;
  double forwards = 0.0, heat = 0.0, rows = 0.0;  // heat: A²
  seen.lowest = 1e300;
  seen.highest = -1e300;
  for (const Track& track : tracks) {
    const Motion motion = track.motion.velocity.empty() ? motionOf(track) : track.motion;
    seen.duration_s = std::max(seen.duration_s, track.time.back());
    for (size_t k = 0; k < track.rows(); ++k) {
      if (!track.connected[k]) continue;
      seen.lowest = std::min(seen.lowest, track.position[k]);
      seen.highest = std::max(seen.highest, track.position[k]);
      seen.peakInput = std::max(seen.peakInput, std::abs(track.input[k]));
      seen.longestRest_s = std::max(seen.longestRest_s, motion.resting[k] ? motion.rest_s[k] : 0.0);
      if (k > 0 && motion.resting[k - 1] && !motion.resting[k]) ++seen.starts;
      if (k > 0 && motion.way[k] * motion.way[k - 1] < 0.0) ++seen.reversals;
      const double drive = physics.electrical
                               ? (track.input[k] - physics.backEmf * motion.velocity[k]) / physics.resistance
                               : track.input[k];
      heat += drive * drive;
      rows += 1.0;
      if (motion.resting[k] || std::abs(motion.velocity[k]) < 4.0 * motion.velocityNoise) continue;
      speeds.push_back(std::abs(motion.velocity[k]));
      accelerations.push_back(std::abs(motion.acceleration[k]));
      forwards += motion.velocity[k] > 0.0 ? 1.0 : 0.0;
      torques.push_back(std::abs(physics.torqueConstant * drive));
      currents.push_back(model.input == DriveInput::torque ? 0.0 : std::abs(drive));
    }
  }
  seen.travel = std::max(0.0, seen.highest - seen.lowest);
  if (speeds.empty()) return seen;
  const double part = forwards / static_cast<double>(speeds.size());
  seen.bothWays = part > 0.1 && part < 0.9;
  seen.lowSpeed = quantile(speeds, 0.1);
  seen.highSpeed = quantile(speeds, 0.95);
  seen.peakTorque = quantile(torques, 0.99);
  seen.knownLoad = std::abs(physics.gravity);
  seen.peakCurrent = quantile(currents, 0.99);
  seen.usualCurrent = model.input == DriveInput::torque ? 0.0 : std::sqrt(heat / rows);
  seen.peakAcceleration = quantile(accelerations, 0.99);
  return seen;
}

}  // namespace breakaway
