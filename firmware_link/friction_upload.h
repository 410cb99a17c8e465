// A friction compensation onto a board, in parts, checked there as a whole.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "experiment/drive.h"
#include "firmware_link/board_link.h"

namespace breakaway {

/// What a board says that it can hold.
struct FrictionRoom {
  std::size_t mostBins = 0;
  bool holdsStatic = false;  ///< else the static friction stays here
};

/// Writes the table, reads it back, and has the board use it. Errors: what Drive::compensate() says, values that came
/// back as others, the link's.
Result<void> uploadFriction(BoardLink& link, const FrictionCompensation& friction, const FrictionRoom& room);

/// What the board compensates now, the index within a turn; empty when nothing. Errors: a table that is being written,
/// the link's.
Result<FrictionCompensation> downloadFriction(BoardLink& link, bool holdsStatic);

}  // namespace breakaway
