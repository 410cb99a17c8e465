// The noise that a cutoff costs.
#pragma once

#include <vector>

#include "stability/servo_loop.h"

namespace breakaway {

/// White errors of the measurements, one value per tick.
struct SensorNoise {
  double angle_rms_rad = 0.0;
  double current_rms_A = 0.0;
};

/// The rms of an encoder's rounding, count/√12: its error is uniform over a count. It is near white while the rotor
/// passes a tenth of a count or more per tick. Slower, it is a saw tooth whose lines fall into the loop's band, and
/// likewise where nearly a whole number of counts falls to a tick: then up to about three times as much comes through.
double roundingRms_rad(double count_rad);

/// What reaches the loop's signals, rms. Both sources add in squares.
struct LoopNoise {
  double estimate_Nm = 0.0;           ///< τ̂
  double estimateByEncoder_Nm = 0.0;  ///< the encoder's part alone
  double currentReference_A = 0.0;
  double currentReferenceByEncoder_A = 0.0;
  double velocity_rad_per_s = 0.0;          ///< of the rotor itself, which the noise shakes
  double velocityEstimate_rad_per_s = 0.0;  ///< of the controller's speed
  double voltage_V = 0.0;                   ///< at the bridge; 0 without winding
};

/// Stationary rms values of the closed loop by the discrete Lyapunov equation (stationaryRms()); quantities of
/// ServoController::step() at the tick. Errors: the loop is not stable. Precondition: check(loop).
Result<LoopNoise> loopNoise(const ServoLoop& loop, const SensorNoise& noise);

/// loopNoise() at each cutoff in rad/s; NaN in every field where the loop is not stable.
std::vector<LoopNoise> noiseOverCutoff(const ServoLoop& loop, const SensorNoise& noise,
                                       const std::vector<double>& cutoffs_rad_per_s);

/// `count` bandwidths of an inner loop, from 0.02/T to 1/T on a logarithmic scale, and `extra_rad_per_s` among them,
/// rising. Precondition: count ≥ 2.
std::vector<double> bandwidthsAround(double extra_rad_per_s, double tick_s, size_t count);

/// The current reference's noise over the speed observer's bandwidth, everything else as it is.
struct ObserverNoise {
  std::vector<double> bandwidth_rad_per_s, current_A;  ///< rms; NaN where the loop is not stable
  double inUse_rad_per_s = 0.0;                        ///< the loop's own bandwidth, one of those
};

/// At bandwidthsAround() the loop's own. Precondition: check(loop), count ≥ 2.
ObserverNoise noiseOverObserver(const ServoLoop& loop, const SensorNoise& noise, size_t count);

}  // namespace breakaway
