// How foreign rigs go, in semi-implicit steps of 10 µs or less, and what their sensors read.
#pragma once

#include <vector>

#include "support/foreign_concealed.h"
#include "support/foreign_draw.h"
#include "support/foreign_motor.h"
#include "support/foreign_moves.h"

namespace breakaway::test {

struct Sensors {
  double lineError = 0.0, wander = 0.0, wander_s = 1.0;
  double noise_A = 0.0, step_A = 0.0, missing = 0.0;
  double pull = 0.0;  ///< a steady torque too small to matter
  std::vector<Wave> trifles;
};

/// One per tick of the loop: time in s, angle or place as shown, drive in V or A as asked for, current in A as read.
struct Rows {
  std::vector<double> time, shown, drive, current;
  double lowest = never, highest = -never;  ///< angle or place, as it is
};

/// One recording, from rest at zero; `draw` for noise and wander.
Rows rowsOf(const Motor& motor, const Driven& driven, const Concealed& hidden, const Sensors& sensors,
            const Moves& moves, double length_s, double rate_Hz, Draw& draw);

}  // namespace breakaway::test
