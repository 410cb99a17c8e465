// How much it costs to leave a trial's physics out: what effects are sized by.
#pragma once

#include "trial/trial_recorder.h"
#include "trial/trial_rig.h"

namespace breakaway {

/// Rms position error of the rig without its concealed physics (inertia, viscous and Coulomb friction and resistance
/// refitted by Gauss and Newton's method) over windows of 0.5 s that restart from the exact state, in units of
/// sensorFloor().
double costOfLeavingOut(const TrialRig& rig, const TrialTrace& trace);

/// Rms position error that a perfect model shows over such windows: the encoder's floor, the restart's speed from some
/// tens of rows of it, and noise in the drive's current and torque, integrated twice. rad or m.
double sensorFloor(const TrialRig& rig);

}  // namespace breakaway
