// How far base and extended model err, on training and on held-out data.
#pragma once

#include <string>

#include "base/statistics.h"

namespace breakaway {

/// RMSE of the position, or of the speed where that alone was measured, over windows that restart every window_s, as
/// simulate() does it; or of the torque along the motion, where that can't be foreseen (ErrorIn::torque).
struct FitScore {
  std::string channel;
  bool inTorque() const { return channel.starts_with("torque") || channel.starts_with("force"); }
  double window_s = 0.5;
  double trainBefore = 0.0, trainAfter = 0.0;
  double heldoutBefore = 0.0, heldoutAfter = 0.0;
  Interval before95, after95;  ///< of the held-out errors
  double improvementLow95 = 0.0, improvementHigh95 = 0.0;
  bool separateRecording = false;
  double floor = 0.0;            ///< of a perfect model, given sensors and restarts
  double floorWithWander = 0.0;  ///< the same where the torque wanders as it does here
};

}  // namespace breakaway
