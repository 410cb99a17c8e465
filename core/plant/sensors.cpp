#include "plant/sensors.h"

#include <algorithm>

#include "base/numbers.h"

namespace breakaway {

EncoderModel::EncoderModel(const Rig& rig)
    : countsPerRad_(rig.encoder.countsPerRev / turn_rad),
      index_rad_(rig.encoder.indexPlace_rad),
      hasIndex_(rig.encoder.hasIndex),
      disc_{rig.encoder.eccentricity_rad, rig.encoder.eccentricityPhase_rad},
      quadrature_rad_(rig.encoder.quadratureError_counts / countsPerRad_),
      linesPerTurn_(0.25 * rig.encoder.countsPerRev),
      indexWidth_rad_(rig.encoder.indexWidth_counts / countsPerRad_) {
  for (const RigEffect& effect : rig.effects) {
    if (effect.effect == "encoder_eccentricity")
      effect_ = {effect.parameter("amplitude_rad"), effect.parameter("phase_rad")};
  }
}

double EncoderModel::shown(double angle_rad) const {
  double shown_rad = angle_rad + effect_.amplitude_rad * std::cos(angle_rad - effect_.phase_rad);
  if (disc_.amplitude_rad != 0.0) shown_rad += disc_.amplitude_rad * std::cos(angle_rad - disc_.phase_rad);
  if (quadrature_rad_ != 0.0) shown_rad += quadrature_rad_ * std::cos(linesPerTurn_ * angle_rad);
  return shown_rad;
}

EncoderModel::Reading EncoderModel::read(double angle_rad) {
  const double shown_rad = shown(angle_rad);
  const auto entered = static_cast<int64_t>(std::floor((angle_rad - index_rad_) / turn_rad));
  const auto left = static_cast<int64_t>(std::floor((angle_rad - index_rad_ - indexWidth_rad_) / turn_rad));
  if (first_) {
    startCounts_ = shown_rad * countsPerRad_;
    entered_ = entered;
    left_ = left;
    first_ = false;
  }
  const bool index = hasIndex_ && (entered > entered_ || left < left_);
  entered_ = entered;
  left_ = left;
  return {static_cast<int64_t>(std::floor(shown_rad * countsPerRad_ - startCounts_)), index};
}

CurrentSensorModel::CurrentSensorModel(const Rig& rig, uint64_t seed)
    : sensor_(rig.currentSensor),
      step_V_(sensor_.adcRange_V / std::exp2(sensor_.adcBits)),
      supplied_(1.0 + sensor_.supplyDeviation_V / sensor_.adcRange_V),
      noise_(seed) {
  for (const RigEffect& effect : rig.effects) {
    if (effect.effect == "current_sensor_offset") sensor_.offset_A += effect.parameter("offset_A");
  }
}

double CurrentSensorModel::read(double current_A, double time_s) {
  double gain = 1.0 + sensor_.gainError, warm_V = 0.0;
  if (sensor_.temperatureRise_degC != 0.0) {
    const double warmer_degC = -sensor_.temperatureRise_degC * std::expm1(-time_s / sensor_.temperatureTime_s);
    gain *= 1.0 + sensor_.gain_per_degC * warmer_degC;
    warm_V = sensor_.offset_V_per_degC * warmer_degC;
  }
  const double shown_A =
      current_A * gain + sensor_.offset_A + sensor_.drift_A_per_s * time_s + sensor_.noiseRms_A * noise_.normal();
  const double middle_V = 0.5 * sensor_.adcRange_V;
  const double volts = std::clamp(supplied_ * (middle_V + sensor_.sensitivity_V_per_A * shown_A) + warm_V, 0.0,
                                  sensor_.adcRange_V - step_V_);
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
