// What tests that move the motor freely leave: means over short blocks of ticks.
#pragma once

namespace breakaway {

/// Means over one block of ticks; the angle is at the block's end.
struct SpinBlock {
  double end_s = 0.0;
  double duration_s = 0.0;
  double angle_rad = 0.0;
  double current_A = 0.0;
  double voltage_V = 0.0;
};

}  // namespace breakaway
