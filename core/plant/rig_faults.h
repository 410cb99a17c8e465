// Faults that a simulated rig plays at a given time, so that a person and a test can meet them without breaking
// anything.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/axis.h"

namespace breakaway {

class JsonObject;

enum class FaultKind {
  linkLoss,
  overCurrent,
  blocked,
  encoderJump,
  indexLost,
  falseIndex,
  supplyDrop,
  temperatureDrift
};

/// One entry of a rig file's `faults`, from start_s on for duration_s of board time. A kind's own parameters:
/// - link_loss: none. Samples stop, and the board's lease runs out.
/// - over_current: current_A that flows past the winding and through the sensor, as in a shorted bridge.
/// - blocked: the shaft is held fast; with angle_rad (from the index) from the moment on at which it passes there.
/// - encoder_jump: counts by which the counter slips, once; it stays so when the fault is over.
/// - index_lost: the index is not seen.
/// - false_index: the index is also seen at angle_rad from where it is.
/// - supply_drop: part of the supply that is left.
/// - temperature_drift: offset_A_per_s of the current sensor's zero and resistance_per_s, the winding's relative
/// growth.
///   What has drifted goes back when the fault is over.
struct RigFault {
  FaultKind kind = FaultKind::linkLoss;
  double start_s = 0.0;
  double duration_s = std::numeric_limits<double>::infinity();
  double current_A = 0.0;
  double counts = 0.0;
  double angle_rad = std::numeric_limits<double>::quiet_NaN();  ///< NaN: anywhere
  double part = 1.0;
  double offset_A_per_s = 0.0;
  double resistance_per_s = 0.0;

  bool acts(double time_s) const { return time_s >= start_s && time_s < start_s + duration_s; }
};

/// The field `faults` of a rig file; none when it is missing. On a linear axis places are `position_m`, from the lower
/// stop, one rad of the shaft being `unitPerRad`. What is wrong becomes a fault of `root`.
std::vector<RigFault> readFaults(JsonObject& root, Axis axis, double unitPerRad);

}  // namespace breakaway
