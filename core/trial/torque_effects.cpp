#include "trial/trial_effect_tables.h"

namespace breakaway {

namespace {

using enum TrialMove;

Concealed constantLoad(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const double against = drawnSign(random) * size * drawn(random, 0.2, 0.6) * rig.coulomb();
  rig.physics.load = -against;
  return {"constant_load", {{torqueNamed("load", rig), against}}};
}

Concealed imbalance(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const Harmonic wave = drawnWave(size * drawn(random, 0.015, 0.05) * rig.peakTorque, 1, 1, random);
  rig.physics.position.push_back(wave);
  return {"imbalance", waveTruth(torqueNamed("amplitude", rig), wave)};
}

Concealed cogging(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const Harmonic wave = drawnWave(size * drawn(random, 0.015, 0.05) * rig.peakTorque, 4, 24, random);
  rig.physics.position.push_back(wave);
  return {"cogging", waveTruth(torqueNamed("amplitude", rig), wave)};
}

Concealed torqueRipple(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const Harmonic wave = drawnWave(size * drawn(random, 0.05, 0.14), 2, 18, random);
  rig.physics.ripple.push_back(wave);
  return {"torque_ripple", waveTruth("amplitude", wave)};
}

Concealed torqueSaturation(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const double steepness = drawn(random, 0.6, 0.9) * size;
  rig.physics.saturationTorque = rig.peakTorque / steepness;
  return {"torque_saturation", {{torqueNamed("saturation", rig), rig.physics.saturationTorque}}};
}

}  // namespace

std::vector<TrialEffect> torqueEffects() {
  TrialNeeds any, rotary, free, rotaryWindings, windings;
  rotary.rotary = free.rotary = free.noPendulum = rotaryWindings.rotary = true;
  rotaryWindings.windings = windings.windings = true;
  return {{"constant_load", any, {multisine, turns, steps}, 30.0, constantLoad},
          {"imbalance", free, {turns, multisine, ramps}, 30.0, imbalance},
          {"cogging", rotary, {turns, ramps, multisine}, 30.0, cogging},
          {"torque_ripple", rotaryWindings, {turns, heavy, multisine, chirp}, 35.0, torqueRipple},
          {"torque_saturation", windings, {heavy, multisine, reversals, turns}, 30.0, torqueSaturation}};
}

}  // namespace breakaway
