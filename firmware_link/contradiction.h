// Which wire is wrong when voltage, current and motion don't belong to one motor.
#pragma once

#include <optional>
#include <string>

#include "base/axis.h"
#include "base/message.h"

namespace breakaway {

/// Of the tick that tripped, and what the board believes of the motor.
struct MotorFigures {
  double voltage_V = 0.0, current_A = 0.0, velocity_rad_per_s = 0.0;
  double before_rad_per_s = 0.0;  ///< its mean over the watch's last 20 ms
  double resistance_ohm = 0.0, backEmf_V_s_per_rad = 0.0;
  double trip_A = 0.0;
  Axis axis = Axis::rotary;
  std::optional<double> mean_A = {};  ///< of the current over the watch's last 20 ms, where that is known
  std::optional<double> mean_V = {};  ///< likewise of the voltage
  double inductive_V = 0.0;           ///< of mean_V, that the change of the current took as it is measured
};

enum class WiringCause {
  unknown,
  encoderReversed,
  encoderStands,
  countsFactor,
  sensorReversed,
  bridgeReversed,
  sensorOrBridgeReversed,
  sensorDead,
  leadOff
};

/// With its unit.
std::string shaftSpeedText(double speed, Axis axis);

/// By the signature: which of current and motion is missing, or against the voltage; a motor that is driven has
/// neither. Of a sensor and a bridge the other way round each foretells another voltage, which parts them while the
/// shaft turns; where that can't tell, whether the shaft speeds up does.
WiringCause causeOf(const MotorFigures& motor);
/// What it is, with its figures, and what to do about it.
Message contradictionWords(const MotorFigures& motor);

}  // namespace breakaway
