// Makes a rig follow its course and records what its sensors show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/recording.h"
#include "trial/trial_course.h"
#include "trial/trial_rig.h"

namespace breakaway {

/// The exact signals behind a recording, row by row.
struct TrialTrace {
  std::vector<double> position;  ///< as the encoder would show it without floor, rad
  std::vector<double> current;   ///< true, A
  std::vector<double> input;     ///< the command as the plant takes it: V or Nm
};

/// Plays the course under the rig's loop at the row rate. The recording holds these columns: the command
/// exactly as applied (held until the next row), the encoder floored to its count, the current with noise, converter
/// steps and offset.
/// `trace`, when given, receives what no sensor of the rig shows.
Recording recordTrial(const TrialRig& rig, const TrialCourse& course, const std::string& name, std::uint64_t seed,
                      TrialTrace* trace = nullptr);

/// The controller as the bench file describes it, in amperes per rad.
BenchController describedLoop(const TrialRig& rig);

}  // namespace breakaway
