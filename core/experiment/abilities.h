// What a board can't do, in words, for whoever is about to ask it.
#pragma once

#include <string>

#include "base/message.h"
#include "experiment/drive.h"

namespace breakaway {

enum class Task { homing, identification, sweep, tuning, compensation, commissioning };

/// Why this board can't do it, in one line; empty when it can.
Message obstacleTo(Task task, const Identity& board);

}  // namespace breakaway
