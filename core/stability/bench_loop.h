// The loop that a board closes around the motor of a bench file.
#pragma once

#include "motor/bench.h"
#include "stability/servo_loop.h"

namespace breakaway {

/// What a bench file doesn't say of the board.
struct BoardTiming {
  double tick_s = 2e-4;
  int delay_ticks = 1;  ///< the command of a sample acts from the next tick on
};

/// Motor, encoder and winding as believed, the controller tuned on the same values, its current limit that of the bench
/// file (0: none given), speed observer and current loop as fast as on the boards. Without resistance or inductance the
/// current is taken as ideal: held at its reference. A missing torque constant is the back-EMF constant, which is the
/// same quantity in SI. On a linear axis read m for rad, kg for kg m², N for Nm. Errors: no torque constant, no
/// inertia.
Result<ServoLoop> loopOfBench(const Bench& bench, const BoardTiming& timing);

}  // namespace breakaway
