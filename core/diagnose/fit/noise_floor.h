// What a perfect model would show, given the sensors and the restarts.
#pragma once

#include <vector>

#include "diagnose/fit/torque_noise.h"
#include "diagnose/fit/window_residual.h"
#include "diagnose/model/excitation.h"
#include "diagnose/model/model.h"

namespace breakaway {

/// How friction differs from one time to the next: no rig's is quite the same twice.
struct FrictionScatter {
  double relative = 0.0;  ///< standard deviation near standstill, of the Coulomb friction
  double speed = 1.0;     ///< up to which it does, rad/s or m/s
  double wander = 0.0;    ///< of the torque at any speed, rms, Nm or N
  double wander_s = 0.1;  ///< its correlation time
};

/// As on a sound rig: near standstill by 1 % up to a tenth of its higher speeds, and a torque that wanders as `left`,
/// what a model of this Coulomb friction leaves, but no more than mostWander().
FrictionScatter usualScatter(const Excitation& seen, double coulomb, const TorqueNoise& left, const Criteria& criteria);

/// RMSE over `windows` of a model against itself: each window's motion is simulated, read through the sensor (quantised
/// where the encoder is declared, with the reading noise otherwise), and then predicted from a restart on those
/// readings. With `scatter`, the friction of what is simulated is a little off in each window, and a torque wanders
/// at random (Ornstein and Uhlenbeck's process). rad or m; of speed alone rad/s or m/s.
double noiseFloor(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows,
                  std::uint64_t seed, const FrictionScatter& scatter = {});

/// Mean squared error of such replays, window by window, over several of them. Where a small cause grows (a pendulum
/// near its top, the edge of standstill), it is large.
std::vector<double> usualSquares(const Model& model, const std::vector<Track>& tracks,
                                 const std::vector<Window>& windows, std::uint64_t seed,
                                 const FrictionScatter& scatter);

}  // namespace breakaway
