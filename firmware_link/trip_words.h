// Why a board opened the windings by itself, for a person.
#pragma once

#include <string>

#include "base/message.h"
#include "control/board_watch.h"
#include "firmware_link/contradiction.h"

namespace breakaway {

/// The figures of the tick in which it happened, and of the limits that were passed.
struct TripFigures {
  double current_A = 0.0, trip_A = 0.0, limit_A = 0.0;
  double supply_V = 0.0, nominalSupply_V = 0.0;
  double jumpedCounts = 0.0, blockedFor_s = 0.0;
  MotorFigures motor = {};
};

/// What happened and what to do about it.
Message tripWords(Trip trip, const TripFigures& figures);

/// The same for a link that is gone; `silent_s` is how long nothing has come.
Message linkLossWords(double silent_s);

}  // namespace breakaway
