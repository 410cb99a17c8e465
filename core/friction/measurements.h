// What sweeps measure around the rotor, before it becomes a map.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "friction/friction_map.h"

namespace breakaway {

/// One zeroing of the current sensor: the zero as the board takes it, counted from the one before a sweep's first, in
/// A.
struct ZeroReading {
  double time_s = 0.0;
  double zero_A = 0.0;
  size_t samples = 0;
  double beyondMean_A = 0.0;  ///< by which the zero lies off the mean of what a coarse converter shows of it
  double hidden_A = 0.0;      ///< standard error of that; the noise's is apart
};

/// One breakaway: a current ramp from standstill until sustained motion, dated back to the last standing sample.
struct BreakawayEvent {
  double angle_rad = 0.0;  ///< where the rotor really stood, from the index, in [0, 2π)
  Way way = Way::ccw;
  size_t turn = 0;
  size_t bin = 0;
  double time_s = 0.0;
  double zero_A = 0.0;  ///< of the sensor, that the currents are counted from
  double current_A =
      0.0;  ///< at the breakaway, positive in the way's direction, the observer's and the motion's lag taken off
  double torque_Nm = 0.0;  ///< torque constant · current
  bool outlier = false;    ///< far from its neighbours; marked, never hidden

  /// The ramp in sums over its standing samples, for a calibration over many ramps: what was commanded (as a current by
  /// the winding's line) and what the sensor showed, both positive in the way's direction.
  double commanded_A = 0.0;  ///< at the breakaway, lag taken off
  double lag_A = 0.0;        ///< by which the ramp grew until the encoder showed motion
  double commandedMean_A = 0.0;
  double measuredMean_A = 0.0;
  double commandedVariance_A2 = 0.0;
  double covariance_A2 = 0.0;
  size_t samples = 0;
};

/// Sums over all samples that fell into one bin of rotor angle.
struct AngleBinSums {
  size_t samples = 0;
  double current_A = 0.0, currentSquared_A2 = 0.0;
  double velocity_rad_per_s = 0.0, velocitySquared = 0.0;

  void add(double amps, double rad_per_s) {
    ++samples;
    current_A += amps;
    currentSquared_A2 += amps * amps;
    velocity_rad_per_s += rad_per_s;
    velocitySquared += rad_per_s * rad_per_s;
  }
  void add(const AngleBinSums& other) {
    samples += other.samples;
    current_A += other.current_A;
    currentSquared_A2 += other.currentSquared_A2;
    velocity_rad_per_s += other.velocity_rad_per_s;
    velocitySquared += other.velocitySquared;
  }
};

/// Some whole turns of a run. The speed at either end is smoothed over the turns next to it: what changes from turn to
/// turn is no part of the rotor's own ripple.
struct RunBlock {
  size_t turns = 0;
  double startSpeed_rad_per_s = 0.0, endSpeed_rad_per_s = 0.0;
  double startWobble_rad_per_s = 0.0, endWobble_rad_per_s = 0.0;  ///< of the commanded speed, off the bins' speeds
  std::vector<AngleBinSums> bins;
};

/// Commanded speeds that differ by rounding alone.
inline bool isSameSpeed(double one, double other) {
  return std::abs(one - other) <= 1e-6 * std::abs(other);
}

/// Whole turns at one commanded speed; signs as the board gives them.
struct VelocityRun {
  double target_rad_per_s = 0.0;
  size_t turns = 0;
  double duration_s = 0.0;
  double middle_s = 0.0;    ///< time of the run's middle
  double zero_A = 0.0;      ///< of the sensor, that the currents are counted from
  double halfSpan_s = 0.0;  ///< speeds are central differences over ± this time
  double start_rad = 0.0;   ///< angle from the index at which the first turn began, and all others
  std::vector<AngleBinSums> bins;
  std::vector<RunBlock> blocks;  ///< the same by stretches of whole turns, for the scatter between them
  bool brokenOff = false;        ///< another run at this speed measures what is left

  Way way() const { return target_rad_per_s < 0.0 ? Way::cw : Way::ccw; }
  bool isAt(double speed_rad_per_s) const { return isSameSpeed(target_rad_per_s, speed_rad_per_s); }
};

/// Sums over all samples of one way of a linear axis that fell into one bin of its travel; signs as the board gives
/// them.
struct TravelBinSums {
  size_t samples = 0;
  double current_A = 0.0, velocity_m_per_s = 0.0;
  double acceleration_m_per_s2 = 0.0;  ///< by the speeds at either end of the bin
};

/// Strokes to and fro over a linear axis' travel at one speed.
struct TravelRun {
  double target_m_per_s = 0.0;
  double duration_s = 0.0, middle_s = 0.0;
  double zero_A = 0.0;      ///< of the sensor, that the currents are counted from
  double halfSpan_s = 0.0;  ///< speeds at the bins' ends are central differences over ± this time
  std::array<std::vector<TravelBinSums>, 2> bins;  ///< by Way
  bool brokenOff = false;                          ///< another run at this speed measures what is left

  bool isAt(double speed_m_per_s) const { return isSameSpeed(target_m_per_s, speed_m_per_s); }
};

}  // namespace breakaway
