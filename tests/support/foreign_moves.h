// The ways to move foreign rigs: steps, a chirp or sines of the drive, or speeds, slow turns or places by a loop.
#pragma once

#include <functional>

#include "support/foreign_concealed.h"
#include "support/foreign_draw.h"
#include "support/foreign_motor.h"

namespace breakaway::test {

/// What is asked for: a drive by itself, or a speed or place that a loop follows.
struct Moves {
  const char* words = "";
  std::function<double(double)> drive, reference;
  bool place = false;
  double kp = 0.0, ki = 0.0, kd = 0.0;
};

/// In V where `volts`, else in A. `travels`: as far as physics that depends on the place needs.
Moves movesFrom(bool travels, const Motor& m, const Concealed& c, bool volts, double length_s, double rate_Hz,
                Draw& draw);

}  // namespace breakaway::test
