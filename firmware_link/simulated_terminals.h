// A simulated rig's terminals, where what is wired wrongly changes what the board reads and what the winding gets.
#pragma once

#include <cstdint>
#include <vector>

#include "plant/rig_wiring.h"

namespace breakaway {

class SimulatedTerminals {
 public:
  explicit SimulatedTerminals(const std::vector<RigWiring>& wiring) : wiring_(wiring) {}

  /// From now on things are as at this rig time, once per control tick.
  void at(double time_s);
  /// The counter, once per control tick: it goes on from where it is when its wiring changes.
  int64_t count(int64_t encoder);
  bool index(bool seen) const;
  /// +1, or −1 where the sensor sees the current the other way round.
  double sensorWay() const { return has(WiringKind::currentSensorReversed) ? -1.0 : 1.0; }
  bool sensorDead() const { return has(WiringKind::currentSensorDead); }
  double supplyReading(double supply_V) const { return supply_V * factor(WiringKind::supplyReadingFactor); }
  double voltage(double voltage_V) const { return has(WiringKind::bridgeReversed) ? -voltage_V : voltage_V; }
  bool leadOff() const { return has(WiringKind::leadOff); }

 private:
  bool has(WiringKind kind) const;
  double factor(WiringKind kind) const;

  std::vector<RigWiring> wiring_;
  double time_s_ = 0.0;
  int64_t encoder_ = 0;
  double counter_ = 0.0;
  bool begun_ = false;
};

}  // namespace breakaway
