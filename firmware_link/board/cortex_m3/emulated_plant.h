// The rig's physics in single precision, light enough to run beside the controller on the same emulated chip.
// Freestanding.
#pragma once

#include <cstdint>

#include "firmware_link/board/cortex_m3/emulated_noise.h"
#include "firmware_link/board/cortex_m3/emulated_rig.h"

namespace breakaway {

/// The equations of `core/plant/plant.h` without its concealed effects: exact transition of winding and shaft over a
/// substep with the dry torques held at their mid-step value; standing still until the motor's torque exceeds static
/// friction; coming to rest where the speed passes zero. The angle is whole 2^-36 turns, so that it never loses digits.
/// A plant of its own because the chip has no floating-point unit: that plant's double precision, exponentials and
/// tables on the heap would cost it many ticks; the tables here come from that plant's own functions.
class EmulatedPlant {
 public:
  EmulatedPlant(const EmulatedRig& rig, std::uint32_t seed);

  void applyVoltage(float voltage_V) {
    perInductance_ = voltage_V * inverseInductance_;
    target_A_ = voltage_V * inverseResistance_;
    open_ = false;
  }
  void openWindings() { open_ = true; }
  /// One control tick.
  void advance();

  std::int64_t angle_q36() const { return angle_q36_; }  ///< from the index, in turns · 2^36
  float velocity_rad_per_s() const { return velocity_; }
  float current_A() const { return open_ ? 0.0f : current_; }
  bool standing() const { return !moving_; }

 private:
  struct Local {
    float static_Nm, coulomb_Nm, viscous, position_Nm;
  };

  Local localAt(std::int64_t angle_q36, int way) const;
  EmulatedMotion motionOver(float duration_s) const;
  float stand(float duration_s);
  float slide(float duration_s);
  void comeToRest();

  const EmulatedRig& rig_;
  float inverseInductance_, inverseResistance_, inverseInertia_, inverseTorqueConstant_, inverseStribeck_, rate_per_s_;
  EmulatedNoise noise_;
  std::int64_t angle_q36_, rest_q36_;
  float velocity_ = 0, acceleration_ = 0, current_ = 0, perInductance_ = 0, target_A_ = 0;
  float scatter_[2] = {1.0f, 1.0f};
  int way_ = 1;
  bool open_ = true, moving_ = false;
};

}  // namespace breakaway
