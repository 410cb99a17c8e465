// What a perfect model would show, given the sensors and the restarts.
#pragma once

#include <vector>

#include "diagnose/fit/window_residual.h"
#include "diagnose/simulate/model.h"

namespace breakaway {

/// How friction near standstill differs from one time to the next: no rig's is quite the same twice.
struct FrictionScatter {
  double relative = 0.0;  ///< standard deviation, of the Coulomb friction
  double speed = 1.0;     ///< up to which it does, rad/s or m/s
};

/// As any rig's does: by 1 % up to a tenth of its higher speeds.
FrictionScatter usualScatter(double highSpeed);

/// RMSE over `windows` of a model against itself: each window's motion is simulated, read through the sensor (quantised
/// where the encoder is declared, with the reading noise otherwise), and then predicted from a restart on those
/// readings. With `scatter`, the friction of what is simulated is a little off in each window. rad or m.
double noiseFloor(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows,
                  std::uint64_t seed, const FrictionScatter& scatter = {});

}  // namespace breakaway
