// What a recording's values contradict, whatever its columns are called.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "recording/recording.h"

namespace breakaway {

/// Each contradiction in a sentence that begins with "implausible"; empty where there is none. Looked for are a drive
/// (voltage, duty, current, torque, force) against which the axis moves most of the time, one that never changes its
/// sign although the motion goes both ways, and steps of time within which nothing could turn as fast as is recorded.
std::vector<Message> contradictionsIn(const Recording& recording);

}  // namespace breakaway
