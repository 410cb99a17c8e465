// The course of a sealed trial: what the motor is made to do, chosen so that it shows the physics in question.
#pragma once

#include <vector>

#include "base/statistics.h"
#include "trial/trial_rig.h"

namespace breakaway {

/// One way of moving.
enum class TrialMove {
  multisine,  ///< five sines between 0.1 and 3 Hz
  steps,      ///< random speeds, held for 0.3 to 1.2 s
  ramps,      ///< slow triangles through zero
  rests,      ///< short moves with rests of very different length between them
  reversals,  ///< hard reversals
  turns,      ///< constant speeds, each way for whole turns
  chirp,      ///< torque from 2 to 100 Hz on top of slow motion
  heavy,      ///< full reversals that heat the winding
  idle,       ///< hardly any motion: for what is to stay hidden
};

/// What to follow, row by row.
struct TrialCourse {
  double row_s = 1e-3;
  std::vector<double> velocity;  ///< rad/s, its slope within what the drive can give
  std::vector<double> position;  ///< its integral, rad
  std::vector<double> shake;     ///< torque on top, Nm
};

/// Stretches of 4 to 8 s of the given moves in turn until the duration is full.
TrialCourse drawCourse(const TrialRig& rig, const std::vector<TrialMove>& moves, double duration_s, Random& random);

}  // namespace breakaway
