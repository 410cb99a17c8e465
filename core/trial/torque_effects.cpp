#include "trial/trial_effect_tables.h"

namespace breakaway {

namespace {

using enum TrialMove;

Concealed constantLoad(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  double& load = rig.physics.constantLoad;
  load = drawnSign(random) * size * drawn(random, 0.2, 0.6) * rig.physics.friction.coulomb;
  return {"constant_load", {{torqueNamed("load", rig), load}}};
}

Concealed imbalance(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  rig.physics.imbalance = drawnWave(size * drawn(random, 0.015, 0.05) * rig.peakTorque, 1, 1, random);
  return {"imbalance", waveTruth(torqueNamed("amplitude", rig), rig.physics.imbalance)};
}

Concealed cogging(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  rig.physics.cogging = drawnWave(size * drawn(random, 0.015, 0.05) * rig.peakTorque, 4, 24, random);
  return {"cogging", waveTruth(torqueNamed("amplitude", rig), rig.physics.cogging)};
}

Concealed torqueRipple(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  rig.physics.ripple = drawnWave(size * drawn(random, 0.05, 0.14), 2, 18, random);
  return {"torque_ripple", waveTruth("amplitude", rig.physics.ripple)};
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
