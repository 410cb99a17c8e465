// A rig as the emulated board carries it: single precision, tabulated when the image is built. Freestanding.
#pragma once

#include <cstdint>

namespace breakaway {

/// Torques around the rotor at one place of the grid; indexed by way, 0 falling angle (cw), 1 growing angle (ccw).
struct EmulatedCell {
  float static_Nm[2], coulomb_Nm[2], viscous_Nm_s_per_rad[2];
  float position_Nm;  ///< towards growing angle
};

/// Change of (current, speed) over a stretch of time: E·(i, ω) + Γ·(v/L, τ/J), with E = Φ − I, so that what hardly
/// changes keeps its digits in single precision.
struct EmulatedMotion {
  float change[2][2];
  float gamma[2][2];
};

struct EmulatedRig {
  // The clock.
  float tick_s, substep_s;
  int substeps;
  // Motor; the friction is the mean around the rotor, per way, and is part of the motions.
  float torqueConstant_Nm_per_A, backEmfConstant_V_s_per_rad, resistance_ohm, inductance_H, inertia_kg_m2;
  float viscousMean_Nm_s_per_rad[2];
  EmulatedMotion closed[2], opened[2];  ///< of one substep, per way, the windings closed or open
  float stribeckVelocity_rad_per_s, scatterRms;
  const EmulatedCell* cells;  ///< 2^cellBits + 1 of them from the index on, the last one as the first
  int cellBits;
  std::int64_t start_q36;  ///< where the shaft stands at power-up, from the index, in turns · 2^36
  std::int32_t countsPerRev;
  // Current sensor and its converter.
  float sensitivity_V_per_A, gain, offset_A, drift_A_per_s, noiseRms_A, adcRange_V;
  std::int32_t adcSteps;
  // Bridge.
  float supply_V, deadZoneDuty;
};

}  // namespace breakaway
