// Slow motion to and fro until something else is asked: a rotor turning, a linear axis going.
#pragma once

#include <memory>

#include "experiment/drive.h"
#include "experiment/travel.h"

namespace breakaway {

/// Commands a sine of speed from the first sample on; it never ends by itself.
std::shared_ptr<Procedure> slowTurning();
/// Glides between two places at a quarter and three quarters of the travel between the margins; it never ends by
/// itself. `travel`: as the encoder counts it; `tick_s`: of the board's control loop.
std::shared_ptr<Procedure> slowStrokes(const Travel& travel, double tick_s);

}  // namespace breakaway
