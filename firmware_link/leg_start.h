// A procedure's leg as the message that starts it on a board.
#pragma once

#include <cstdint>
#include <vector>

#include "experiment/leg.h"
#include "firmware_link/wire/leg_messages.h"
#include "firmware_link/wire/messages.h"

namespace breakaway {

struct LegStart {
  wire::Type type;
  std::vector<std::uint8_t> body;
};

/// `count_rad` is the angle of one of the board's counts. The limit in `head` is the leg's.
LegStart legStart(const Leg& leg, wire::LegHead head, double count_rad);

}  // namespace breakaway
