// One decoded sample as a drive delivers it: what comes over the link, and nothing of the plant.
#pragma once

#include <cstdint>

namespace breakaway {

struct Sample {
  double time_s = 0.0;
  double angle_rad = 0.0;  ///< encoder counts as an angle: quantised by floor, unwrapped; 0 at power-up until homed
  double velocity_rad_per_s = 0.0;  ///< the board's own estimate
  double current_A = 0.0;           ///< as the sensor gives it, zeroed by the board when it zeroes
  double voltage_V = 0.0;           ///< commanded mean bridge voltage, duty × supply
  double supply_V = 0.0;
  double current_reference_A = 0.0;  ///< after the current limit
  double velocity_reference_rad_per_s = 0.0;
  double angle_reference_rad = 0.0;
  double disturbance_estimate_Nm = 0.0;  ///< disturbance observer's output
  bool index = false;                    ///< the encoder's index was seen in this tick
  bool enabled = false;                  ///< false: windings open
  std::uint8_t legPhase = 0;             ///< of the leg that was asked for last (control/leg); 0: it hasn't begun

  bool operator==(const Sample&) const = default;
};

}  // namespace breakaway
