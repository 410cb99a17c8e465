#include "motor/sensors.h"

#include <algorithm>

namespace breakaway {

namespace {
constexpr double turn = 2.0 * std::numbers::pi;
}

EncoderModel::EncoderModel(const Rig& rig) : countsPerRad_(rig.encoder.countsPerRev / turn) {
  for (const RigEffect& effect : rig.effects) {
    if (effect.effect != "encoder_eccentricity") continue;
    eccentricity_rad_ = effect.parameter("amplitude_rad");
    eccentricityPhase_rad_ = effect.parameter("phase_rad");
  }
}

EncoderModel::Reading EncoderModel::read(double angle_rad) {
  const double shown = angle_rad + eccentricity_rad_ * std::cos(angle_rad - eccentricityPhase_rad_);
  const auto turns = static_cast<int64_t>(std::floor(angle_rad / turn));
  if (first_) {
    startCounts_ = shown * countsPerRad_;
    turns_ = turns;
    first_ = false;
  }
  const bool index = turns != turns_;
  turns_ = turns;
  return {static_cast<int64_t>(std::floor(shown * countsPerRad_ - startCounts_)), index};
}

CurrentSensorModel::CurrentSensorModel(const Rig& rig, uint64_t seed)
    : sensor_(rig.currentSensor), step_V_(sensor_.adcRange_V / std::exp2(sensor_.adcBits)), noise_(seed) {
  for (const RigEffect& effect : rig.effects) {
    if (effect.effect == "current_sensor_offset") sensor_.offset_A += effect.parameter("offset_A");
  }
}

double CurrentSensorModel::read(double current_A, double time_s) {
  const double shown_A = current_A * (1.0 + sensor_.gainError) + sensor_.offset_A + sensor_.drift_A_per_s * time_s +
                         sensor_.noiseRms_A * noise_.normal();
  const double middle_V = 0.5 * sensor_.adcRange_V;
  const double volts = std::clamp(middle_V + sensor_.sensitivity_V_per_A * shown_A, 0.0, sensor_.adcRange_V - step_V_);
  return (std::round(volts / step_V_) * step_V_ - middle_V) / sensor_.sensitivity_V_per_A;
}

double BridgeModel::realisable(double duty) {
  const double wanted = std::clamp(duty + left_, -1.0, 1.0);
  const double made = bridge_.pwmSteps > 0.0 ? std::round(wanted * bridge_.pwmSteps) / bridge_.pwmSteps : wanted;
  left_ = std::clamp(wanted - made, -0.5, 0.5);
  return made;
}

double BridgeModel::voltage(double duty) const {
  if (bridge_.dutyCurve.known()) return bridge_.dutyCurve.output(duty) * bridge_.supply_V;
  const double beyond = std::max(0.0, std::abs(duty) - bridge_.deadZoneDuty);
  return std::copysign(beyond, duty) * bridge_.supply_V;
}

}  // namespace breakaway
