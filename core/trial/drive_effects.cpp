#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "trial/trial_effect_tables.h"
#include "trial/trial_recorder.h"

namespace breakaway {

namespace {

using enum TrialMove;

Concealed deadTime(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  PlantPhysics& p = rig.physics;
  p.deadTime_V = size * drawn(random, 0.015, 0.04) * rig.supply_V;
  p.deadTimeCurrent_A = drawnLog(random, 0.01, 0.05) * rig.peakCurrent_A();
  return {"dead_time", {{"voltage_V", p.deadTime_V}, {"current_A", p.deadTimeCurrent_A}}};
}

Concealed currentOffset(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  double& offset = rig.sensors.currentOffset_A;
  offset = drawnSign(random) * size * drawnLog(random, 0.015, 0.05) * rig.peakCurrent_A();
  return {"current_sensor_offset", {{"offset_A", offset}}};
}

Concealed windingHeating(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  PlantPhysics& p = rig.physics;
  const double rise = size * drawn(random, 0.3, 0.6), typical_A = 0.4 * rig.peakCurrent_A();
  p.heatingTime_s = drawn(random, 12.0, 35.0);
  p.heatingPerJoule = rise / (typical_A * typical_A * p.resistance_ohm * p.heatingTime_s);
  return {"winding_heating", {{"rise_per_J", p.heatingPerJoule}, {"time_constant_s", p.heatingTime_s}}};
}

Concealed supplySag(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  double& resistance = rig.physics.supplyResistance_ohm;
  resistance = size * drawn(random, 0.12, 0.3) * rig.supply_V / rig.peakCurrent_A();
  return {"supply_sag", {{"resistance_ohm", resistance}}};
}

Concealed eccentricity(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  Harmonic& wave = rig.sensors.eccentricity;
  wave = drawnWave(size * drawnLog(random, 0.006, 0.025), 1, 1, random);
  return {"encoder_eccentricity", waveTruth("amplitude_rad", wave)};
}

/// Clips or slows down the drive below what the course asks of it.
Concealed commandSaturation(TrialRig& rig, const TrialCourse& course, double size, Random& random) {
  TrialTrace unlimited;
  (void)recordTrial(rig, course, "unlimited", random.bits(), &unlimited);
  std::vector<double> heights = unlimited.input;
  for (double& height : heights) height = std::abs(height);
  const double peak = quantile(heights, 0.995);  // V or Nm
  const double perInput = rig.input == DriveInput::current ? rig.physics.torqueConstant
                          : rig.input == DriveInput::duty  ? rig.supply_V
                                                           : 1.0;
  if (random.uniform() < 0.3) {
    rig.physics.inputSlew_per_s = 2.0 * peak / (size * drawn(random, 0.01, 0.03));
    return {"command_saturation", {{"slew_per_s", rig.physics.inputSlew_per_s / perInput}}};
  }
  rig.physics.inputLimit = peak * (1.0 - 0.5 * std::min(1.9, size * drawn(random, 0.6, 1.0)));
  return {"command_saturation", {{"limit", rig.physics.inputLimit / perInput}}};
}

Concealed transportDelay(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  rig.physics.delay_s = size * drawnLog(random, 2.0e-3, 7e-3);
  return {"transport_delay", {{"delay_s", rig.physics.delay_s}}};
}

Concealed channelSkew(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  rig.sensors.currentSkew_s = size * drawnLog(random, 1.2e-3, 4e-3);
  return {"channel_skew", {{"skew_s", rig.sensors.currentSkew_s}}};
}

}  // namespace

std::vector<TrialEffect> driveEffects() {
  TrialNeeds any, electrical, seen, rotary;
  electrical.electrical = seen.currentSeen = rotary.rotary = rotary.noPendulum = true;
  return {{"dead_time", electrical, {ramps, reversals, multisine}, 30.0, deadTime},
          {"current_sensor_offset", seen, {multisine, turns, rests}, 30.0, currentOffset, false},
          {"winding_heating", electrical, {heavy, heavy, multisine, heavy, idle}, 60.0, windingHeating},
          {"supply_sag", electrical, {heavy, turns, steps, multisine}, 30.0, supplySag},
          {"encoder_eccentricity", rotary, {turns, multisine, turns}, 30.0, eccentricity},
          {"command_saturation", any, {heavy, multisine, steps}, 30.0, commandSaturation},
          {"transport_delay", any, {steps, reversals, chirp}, 30.0, transportDelay},
          {"channel_skew", seen, {reversals, steps, chirp}, 30.0, channelSkew, false}};
}

}  // namespace breakaway
