// What is connected to this board: motor, encoder, sensor, supply. To be edited for one's own bench.
#pragma once

#include "base/numbers.h"
#include "control/tuning.h"
#include "firmware_link/board/board_hardware.h"

namespace breakaway::lpc1768 {

inline constexpr float tick_s = 200e-6f;
inline constexpr std::uint32_t countsPerRev = 14400;
inline constexpr float supply_V = 24.0f, supplyDivider = 11.0f;  ///< 24 V shows as 2.18 V at AD0.1
inline constexpr float sensor_V_per_A = 0.185f, sensorDivider = 5.0f / 3.3f, sensorMiddle_V = 2.5f;
inline constexpr float adcReference_V = 3.3f;
inline constexpr float range_A = sensorMiddle_V / sensor_V_per_A;

/// A motor of 0.07 Nm/A and 6e-5 kg m²; the first commissioning finds the real values and the host sends them.
inline board::BoardHardware<float> wiredHardware() {
  board::BoardHardware<float> hardware;
  hardware.device = "LPC1768 servo board";
  hardware.firmware = "reference 0.1.0";
  hardware.loopRate_Hz = 1.0f / tick_s;
  hardware.countsPerRev = countsPerRev;
  hardware.supply_V = supply_V;
  hardware.sensorRange_A = range_A;
  hardware.pwmSteps = 4800;
  const float count_rad = static_cast<float>(turn_rad) / static_cast<float>(countsPerRev);
  hardware.servo = {tick_s,
                    count_rad,
                    {1.2f, 0.0011f, 0.07f, boardCurrentBandwidth_rad_per_s(tick_s)},
                    boardVelocityBandwidth_rad_per_s(tick_s)};
  hardware.watch.tick_s = tick_s;
  hardware.watch.count_rad = count_rad;
  hardware.watch.trip_A = 0.95f * range_A;
  hardware.watch.supply_V = supply_V;
  hardware.watch.mostAcceleration_rad_per_s2 = 3.0f * range_A * 0.07f / 6e-5f;
  hardware.watch.resistance_ohm = hardware.servo.current.resistance_ohm;
  hardware.watch.inductance_H = hardware.servo.current.inductance_H;
  hardware.watch.backEmf_V_s_per_rad = hardware.servo.current.backEmfConstant_V_s_per_rad;
  hardware.watch.mostVelocity_rad_per_s = 0.95f * supply_V / 0.07f;
  hardware.watch.continuous_A = 0.375f * range_A;
  hardware.start.gains = tuneMotion(6e-5f, 0.07f, 60.0f, 40.0f);
  hardware.start.gains.velocity_limit_rad_per_s = 0.6f * supply_V / 0.07f;
  hardware.start.observer_cutoff_rad_per_s = tuneObserver(tick_s, boardVelocityBandwidth_rad_per_s(tick_s));
  hardware.start.inertia_kg_m2 = 6e-5f;
  hardware.start.torqueConstant_Nm_per_A = 0.07f;
  hardware.start.current_limit_A = 0.5f * range_A;
  hardware.mostCurrent_A = 0.75f * range_A;
  hardware.mostVelocity_rad_per_s = supply_V / 0.07f;
  return hardware;
}

}  // namespace breakaway::lpc1768
