// What sound rigs and loggers do besides physics: torque that wanders, an encoder's line error, few bits, lost rows.
#pragma once

#include "recording/recording.h"
#include "trial/trial_rig.h"

namespace breakaway {

/// How a log is kept. The controller's rows are those of TrialSensors::row_s.
struct TrialLogger {
  size_t every = 1;        ///< of the controller's rows
  bool meanDrive = false;  ///< the drive's mean over the logged row, else its value as the row begins
  double lostShare = 0.0;  ///< of rows that are missing, one by one
  double lostGaps_per_s = 0.0, longestGap_s = 0.0;
};

/// Draws a sound rig's ways into `rig`: torque that wanders by up to 4.5 % of the Coulomb friction, from what a current
/// loop doesn't follow to slow drift; line error and trifles far below what a model could miss; converters of 9 to 14
/// bits. Returns how it is logged: 100 Hz to 5 kHz, some rows lost.
TrialLogger drawImperfections(TrialRig& rig, Random& random);

/// The recording as such a logger keeps it.
Recording logged(const Recording& recording, const TrialRig& rig, const TrialLogger& logger, Random& random);

}  // namespace breakaway
