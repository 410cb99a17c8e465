// What a perfect model would show, given the sensors and the restarts.
#pragma once

#include <vector>

#include "diagnose/fit/window_residual.h"
#include "diagnose/simulate/model.h"

namespace breakaway {

/// RMSE over `windows` of a model against itself: each window's motion is simulated, read through the sensor (quantised
/// where the encoder is declared, with the reading noise otherwise), and then predicted from a restart on those
/// readings. rad or m.
double noiseFloor(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows,
                  std::uint64_t seed);

}  // namespace breakaway
