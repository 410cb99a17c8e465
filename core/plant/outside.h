// Physics beyond the diagnosis' catalogue as it comes over time.
#pragma once

#include <cstdint>

#include "base/random.h"
#include "plant/physics.h"

namespace breakaway {

/// The state of a plant's OutsidePhysics, drawn anew every 1 ms.
class Outside {
 public:
  Outside(const OutsidePhysics& physics, double step_s, std::uint64_t seed);

  /// At the beginning of each step.
  void step(double time_s, double velocity);
  /// Torque towards growing angle.
  double torque(double angle_rad, double velocity) const;
  /// What adds to the friction against motion at `speed`, of which `coulomb` is the dry part.
  double friction(double speed, double coulomb) const;
  /// What the transmission passes on of the motor's torque.
  double passedOn(double torque) const;

 private:
  OutsidePhysics physics_;
  double step_s_;
  int every_;
  std::int64_t steps_ = 0;
  Random random_;
  double noise_ = 0.0, wander_ = 0.0, burst_s_ = 0.0, laggedSpeed_ = 0.0, breathing_ = 0.0;
};

}  // namespace breakaway
