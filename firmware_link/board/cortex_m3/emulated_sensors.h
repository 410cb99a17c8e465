// What the emulated board sees of its plant: encoder, current sensor, bridge; as `core/plant/sensors.h`, in single
// precision. Freestanding.
#pragma once

#include <cstdint>

#include "firmware_link/board/cortex_m3/emulated_noise.h"
#include "firmware_link/board/cortex_m3/emulated_rig.h"

namespace breakaway {

/// Counts from zero at power-up, rounded down; the index is seen when the shaft passes it.
class EmulatedEncoder {
 public:
  explicit EmulatedEncoder(const EmulatedRig& rig) : rig_(rig), turns_(rig.start_q36 >> 36) {}

  struct Reading {
    std::int32_t count = 0;
    bool index = false;
  };
  Reading read(std::int64_t angle_q36) {
    const std::int64_t turns = angle_q36 >> 36;
    const bool index = turns != turns_;
    turns_ = turns;
    const std::int64_t gone = angle_q36 - rig_.start_q36;  // since power-up
    const std::int64_t part = gone & ((std::int64_t{1} << 36) - 1);
    const std::int64_t count = (gone >> 36) * rig_.countsPerRev + ((part * rig_.countsPerRev) >> 36);
    return {static_cast<std::int32_t>(count), index};
  }

 private:
  const EmulatedRig& rig_;
  std::int64_t turns_;
};

/// A Hall current sensor read by a converter: gain error, offset that drifts, noise, and the converter's steps and
/// range.
class EmulatedCurrentSensor {
 public:
  EmulatedCurrentSensor(const EmulatedRig& rig, std::uint32_t seed)
      : rig_(rig),
        middle_(rig.adcSteps / 2),
        perStep_A_(rig.adcRange_V / static_cast<float>(rig.adcSteps) / rig.sensitivity_V_per_A),
        stepsPer_A_(1.0f / perStep_A_),
        noise_(seed) {}

  /// The converter's code, 0 to adcSteps − 1, `time_s` since power-up.
  std::int32_t code(float current_A, float time_s) {
    const float shown_A =
        current_A * rig_.gain + rig_.offset_A + rig_.drift_A_per_s * time_s + rig_.noiseRms_A * noise_.normal();
    const float place = shown_A * stepsPer_A_ + static_cast<float>(middle_) + 0.5f;
    if (!(place > 0.0f)) return 0;
    const auto code = static_cast<std::int32_t>(place);
    return code < rig_.adcSteps ? code : rig_.adcSteps - 1;
  }
  /// What the board makes of the converter's code with the nominal sensitivity.
  float current_A(std::int32_t code) const { return static_cast<float>(code - middle_) * perStep_A_; }

 private:
  const EmulatedRig& rig_;
  std::int32_t middle_;  ///< code at no current
  float perStep_A_, stepsPer_A_;
  EmulatedNoise noise_;
};

/// The bridge: what mean voltage a commanded duty gives.
class EmulatedBridge {
 public:
  explicit EmulatedBridge(const EmulatedRig& rig) : rig_(rig) {}

  float voltage_V(float duty) const {
    if (duty > rig_.deadZoneDuty) return (duty - rig_.deadZoneDuty) * rig_.supply_V;
    if (duty < -rig_.deadZoneDuty) return (duty + rig_.deadZoneDuty) * rig_.supply_V;
    return 0.0f;
  }

 private:
  const EmulatedRig& rig_;
};

}  // namespace breakaway
