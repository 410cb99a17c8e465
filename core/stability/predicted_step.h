// The step in velocity or in position that a loop is going to make, before any motor makes it.
#pragma once

#include <vector>

#include "stability/servo_loop.h"

namespace breakaway {

struct StepWanted {
  double from_rad_per_s = 0.0;
  double to_rad_per_s = 20.0;
  double to_rad = 0.0;      ///< in position mode, from standstill at 0; the two above don't matter then
  double before_s = 0.1;    ///< at the first speed, so that the loop is settled
  double after_s = 0.6;     ///< from the step on
  double supply_V = 0.0;    ///< of the bridge; 0: no limit
  double coulomb_Nm = 0.0;  ///< friction against every motion
  double static_Nm = 0.0;   ///< what a standing shaft bears; less than coulomb_Nm counts as that
};

/// One value per tick; times from the step on, the first ones lie before it.
struct PredictedStep {
  std::vector<double> time_s, velocity_rad_per_s, current_A, angle_rad;
};

/// The board's own controller code, tick by tick, around the motor of `loop`: shaft with viscous and Coulomb friction,
/// winding (or current held at its reference), encoder's counts, current limit, supply and delay. The mode is
/// velocity or position. Between ticks the motor is stepped through in substeps short against L/R. On a linear axis
/// read m for rad, kg for kg m², N for Nm. Precondition: check(loop).
PredictedStep predictStep(const ServoLoop& loop, const StepWanted& wanted);

}  // namespace breakaway
