// Why a board on the wire stopped the motor, for a person.
#pragma once

#include <string>

#include "firmware_link/trip_words.h"
#include "firmware_link/wire/messages.h"

namespace breakaway {

/// What the board's dictionary says of its limits.
struct FaultLimits {
  double trip_A = 0.0, blockedFor_s = 0.0, lease_s = 0.0, supply_V = 0.0, count_rad = 0.0;
  Axis axis = Axis::rotary;
};

/// The watch's own; none where something else stopped the motor: travel, heat, a lease that ran out.
Trip tripOf(wire::FaultCode code);

/// What happened and what to do about it.
Message faultWords(const wire::Fault& fault, const FaultLimits& limits);

}  // namespace breakaway
