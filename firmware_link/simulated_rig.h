// A simulated rig as a board's hardware sees it: what it measures, and what it drives; and what such a board is told of
// its motor.
#pragma once

#include <cstdint>

#include "firmware_link/board/board_hardware.h"
#include "firmware_link/board_faults.h"
#include "firmware_link/simulated_terminals.h"
#include "plant/plant.h"
#include "plant/rig.h"
#include "plant/sensors.h"

namespace breakaway {

/// Plant, encoder, current sensor and bridge with the rig's faults, one control tick at a time.
class SimulatedRig {
 public:
  /// `seed` drives noise and scatter.
  SimulatedRig(const Rig& rig, unsigned seed);

  struct Reading {
    int64_t count = 0;
    bool index = false;
    double current_A = 0.0;  ///< as the sensor reads
    double supply_V = 0.0;
    bool linkLost = false;  ///< the link carries nothing in this tick
  };
  /// At the beginning of each tick.
  Reading read();
  /// The duty that the timer makes of the one wished for, once per tick.
  double realisable(double duty) { return bridge_.realisable(duty); }
  /// Lets the rest of the tick pass; without `enabled` the windings are open.
  void drive(bool enabled, double duty);
  /// The motor's: rad from the index, rad/s.
  double shaft_rad() const { return plant_.angle_rad(); }
  double shaft_rad_per_s() const { return plant_.velocity_rad_per_s(); }

 private:
  double ticks_s_, rate_Hz_;
  int substeps_;
  Plant plant_;
  EncoderModel encoder_;
  CurrentSensorModel sensor_;
  BridgeModel bridge_;
  BoardFaults faults_;
  SimulatedTerminals terminals_;
  double supply_V_;
  uint64_t tickCount_ = 0;
  double supplyPart_ = 1.0;
};

/// The board of such a rig: its limits from sensor and supply, its settings tuned from the motor's name plate, which
/// gives torque constant and inertia to one significant digit. Device and firmware are left empty.
template <typename Scalar>
board::BoardHardware<Scalar> hardwareOf(const Rig& rig);

}  // namespace breakaway
