// From breakaways and runs at constant speed to the friction map.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/result.h"
#include "friction/friction_map.h"
#include "friction/measurements.h"
#include "identify/velocity_friction.h"

namespace breakaway {

struct MapOptions {
  std::string rig;
  size_t bins = 180;
  size_t turns = 2;
  double torqueConstant_Nm_per_A = 0.0;
  double noiseRms_A = 0.0;                       ///< of the current sensor, per sample
  double zeroError_A = 0.0;                      ///< standard error of its zero, common to all breakaways
  double totalVelocity_rad_per_s = 10.47197551;  ///< 100 rpm
  double angleError_rad = 0.0;                   ///< standard error of where breakaways stood, common to all of them
  double scaleError = 0.0;                       ///< relative standard error of the torque constant
  double calibration = 0.005;                    ///< noise aimed at for each breakaway, part of the mean current
};

/// The breakaways with their currents calibrated over many ramps: commanded current against measured, slope pooled over
/// all ramps, offset averaged over as many neighbours in time as bring the noise down to options.calibration of the
/// mean current. A big motor's ramps stand alone; where friction is a fraction of the sensor's noise, dozens go
/// together.
std::vector<BreakawayEvent> calibrated(std::vector<BreakawayEvent> events, const MapOptions& options);

/// All bins of both ways, filled. Static: per turn interpolated between breakaways at the angles really reached, around
/// the harmonics that all of them follow; mean over turns; the standard error from the scatter between turns, pooled
/// over the bins around, from what the harmonics leave open where no breakaway was measured, and from what all turns
/// share: the zero, the calibration, the lag, the angle, and the torque constant. It holds no error of the sensor's
/// gain, which scales the whole map. With moving friction (indexed by Way, options.bins long) also Coulomb, viscous and
/// total; else these stay zero. Errors: a way with fewer than 8 breakaways.
Result<FrictionMap> estimateMap(const std::vector<BreakawayEvent>& events, const std::array<MovingFriction, 2>* moving,
                                const MapOptions& options);

}  // namespace breakaway
