// What the voltage says where current drives and the voltage was recorded, too.
#pragma once

#include <optional>
#include <vector>

#include "diagnose/fit/window.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

struct SensorOffset {
  double value_A = 0.0;
  double deviation_A = 0.0;  ///< standard deviation
};

/// The current that the sensor shows where none flows: ∫u = R ∫(i − c) + Ke Δx + L Δi + d ∫sgn i, over parts of these
/// windows, by least squares; d is what a bridge's dead time takes. The motion's torque doesn't enter. Its deviation
/// takes each window's parts as one. Nothing where a track has no voltage, or where the resistance doesn't show.
std::optional<SensorOffset> sensorOffset(const std::vector<Track>& tracks, const std::vector<Window>& windows);

}  // namespace breakaway
