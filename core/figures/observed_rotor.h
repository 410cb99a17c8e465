// A rotor under a wandering load as its sensors show it, and as it truly is: what observers are judged by.
#pragma once

#include <cstdint>
#include <vector>

namespace breakaway {

/// A rotor J·dω/dt = Kt·i − τ held at a speed by a stiff drive, its load τ a random walk. Exact between ticks.
struct ObservedRotorOptions {
  double inertia_kg_m2 = 6e-5;
  double torqueConstant_Nm_per_A = 0.07;
  double count_rad = 4.363e-4;
  double tick_s = 2e-4;
  double currentNoise_A = 0.017;         ///< rms of one sample
  double loadWalk_Nm_per_sqrt_s = 0.01;  ///< 17 mNm of friction change by a tenth of it in 30 ms
  double speed_rad_per_s = 10.0;
  double swing_rad_per_s = 0.0;  ///< of the speed, as a sine …
  double swing_Hz = 2.0;
  double duration_s = 4.0;
  double timerStep_s = 1e-8;  ///< of the clock that dates encoder edges
  uint64_t seed = 1;
};

/// One tick: what the sensors say at its beginning, and the truth then and one tick later.
struct ObservedTick {
  double angle_rad = 0.0;           ///< middle of the encoder's count
  double edge_rad = 0.0;            ///< place of the edge passed last
  double sinceEdge_s = 0.0;         ///< how long ago
  double current_A = 0.0;           ///< measured, what flowed over the tick before
  double velocity_rad_per_s = 0.0;  ///< true
  double nextLoad_Nm = 0.0;         ///< true, when an estimate of this tick comes to act
};

std::vector<ObservedTick> observeRotor(const ObservedRotorOptions& options);

}  // namespace breakaway
