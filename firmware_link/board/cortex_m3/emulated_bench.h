// The rig around the controller of the emulated board: what a tick reads, and what its bridge does. Freestanding.
#pragma once

#include <cstdint>

#include "firmware_link/board/board_hardware.h"
#include "firmware_link/board/cortex_m3/emulated_plant.h"
#include "firmware_link/board/cortex_m3/emulated_sensors.h"

namespace breakaway {

class EmulatedBench {
 public:
  EmulatedBench(const EmulatedRig& rig, std::uint32_t seed)
      : rig_(rig), plant_(rig, 2 * seed + 1), encoder_(rig), sensor_(rig, 2 * seed + 2), bridge_(rig) {}

  /// What the port measures at the beginning of a tick.
  board::Readings<float> readings() {
    const EmulatedEncoder::Reading seen = encoder_.read(plant_.angle_q36());
    const std::int32_t code = sensor_.code(plant_.current_A(), static_cast<float>(ticks_) * rig_.tick_s);
    return {seen.count, seen.index, sensor_.current_A(code), rig_.supply_V, 0.0f};
  }

  /// One tick of the rig with the bridge as it was set.
  void advance(const board::Drive<float>& drive) {
    if (drive.enabled) {
      plant_.applyVoltage(bridge_.voltage_V(drive.duty));
    } else {
      plant_.openWindings();
    }
    plant_.advance();
    ++ticks_;
  }

 private:
  const EmulatedRig& rig_;
  EmulatedPlant plant_;
  EmulatedEncoder encoder_;
  EmulatedCurrentSensor sensor_;
  EmulatedBridge bridge_;
  std::uint32_t ticks_ = 0;
};

}  // namespace breakaway
