// A board's settings as its controller takes them.
#pragma once

#include "control/servo_controller.h"
#include "experiment/identity.h"

namespace breakaway {

ServoSettings<double> servoSettings(const ControllerSettings& settings);
/// `present` with the gains, the observer and the nominal values of `tuned`; its limits and
/// bandwidths stay.
ControllerSettings withTuning(const ControllerSettings& present, const ServoSettings<double>& tuned);

}  // namespace breakaway
