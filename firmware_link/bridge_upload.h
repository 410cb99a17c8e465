// The bridge's duty curve onto a board.
#pragma once

#include "base/result.h"
#include "firmware_link/board_link.h"
#include "motor/duty_curve.h"

namespace breakaway {

/// Has the board ask for every voltage through the curve's inverse, and reads back what it took; an unknown curve ends
/// it. Errors: what Drive::linearise() says, a curve that came back as another, the link's.
Result<void> uploadBridge(BoardLink& link, const DutyCurve& curve);

}  // namespace breakaway
