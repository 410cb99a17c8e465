#include <cmath>

#include "trial/trial_effect_tables.h"

namespace breakaway {

namespace {

using enum TrialMove;

Concealed coulombAsymmetry(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.asymmetry = drawnSign(random) * size * drawn(random, 0.3, 0.7) * f.coulomb;
  return {"coulomb_asymmetry", {{torqueNamed("difference", rig), f.asymmetry}}};
}

Concealed viscousAsymmetry(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.viscousAsymmetry = drawnSign(random) * size * drawn(random, 0.02, 0.05) * rig.peakTorque / rig.topSpeed;
  f.viscous += 0.6 * std::abs(f.viscousAsymmetry);
  return {"viscous_asymmetry", {{viscousNamed("difference", rig), f.viscousAsymmetry}}};
}

Concealed stribeck(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.stribeckExcess = size * drawn(random, 0.35, 0.8) * f.coulomb;
  f.stribeckSpeed = drawnLog(random, 0.03, 0.12) * rig.topSpeed;
  f.stribeckExponent = drawn(random, 0.8, 2.0);
  return {"stribeck",
          {{torqueNamed("excess", rig), f.stribeckExcess},
           {speedNamed("velocity", rig), f.stribeckSpeed},
           {"exponent", f.stribeckExponent}}};
}

/// The travel over which friction builds up grows with the size.
Concealed presliding(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  const double full = rig.axis == Axis::rotary ? 0.06 : 1e-3;
  const double travel = std::max(6.0 * rig.sensors.count, size * drawnLog(random, 0.4, 1.5) * full);
  f.stiffness = f.coulomb / travel;
  f.damping = 2.0 * drawn(random, 0.2, 0.5) * std::sqrt(f.stiffness * rig.physics.inertia);
  return {"presliding",
          {{stiffnessNamed("stiffness", rig), f.stiffness}, {viscousNamed("bristle_damping", rig), f.damping}}};
}

Concealed quadraticDrag(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.quadratic = size * drawn(random, 0.05, 0.15) * rig.peakTorque / (rig.topSpeed * rig.topSpeed);
  return {"quadratic_drag",
          {{rig.axis == Axis::rotary ? "coefficient_Nm_s2_per_rad2" : "coefficient_N_s2_per_m2", f.quadratic}}};
}

Concealed frictionOverAngle(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.overAngle = drawnWave(size * drawn(random, 0.25, 0.55) * f.coulomb, 1, 6, random);
  return {"position_dependent_friction", waveTruth(torqueNamed("amplitude", rig), f.overAngle)};
}

Concealed viscousOverAngle(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.viscousOverAngle = drawnWave(size * drawn(random, 0.02, 0.05) * rig.peakTorque / rig.topSpeed, 1, 6, random);
  f.viscous += 1.1 * f.viscousOverAngle.amplitude;
  return {"position_dependent_viscous", waveTruth(viscousNamed("amplitude", rig), f.viscousOverAngle)};
}

Concealed loadFriction(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.ofLoad = size * drawn(random, 0.08, 0.18);
  return {"load_dependent_friction", {{"coefficient", f.ofLoad}}};
}

Concealed warmup(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.warmupExcess = size * drawn(random, 0.6, 1.2) * f.coulomb;
  f.warmupTime_s = drawn(random, 6.0, 18.0);
  return {"friction_warmup", {{torqueNamed("amplitude", rig), f.warmupExcess}, {"time_constant_s", f.warmupTime_s}}};
}

Concealed risingStiction(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  TrialFriction& f = rig.physics.friction;
  f.restExcess = size * drawn(random, 1.0, 2.2) * f.coulomb;
  f.restTime_s = drawnLog(random, 0.3, 1.5);
  f.restTravel = 3.0 * rig.sensors.count;
  return {"rising_stiction", {{torqueNamed("excess", rig), f.restExcess}, {"time_constant_s", f.restTime_s}}};
}

}  // namespace

std::vector<TrialEffect> frictionEffects() {
  TrialNeeds any, rotary, windings;
  rotary.rotary = true;
  windings.windings = true;
  return {{"coulomb_asymmetry", any, {multisine, turns, steps}, 30.0, coulombAsymmetry},
          {"viscous_asymmetry", any, {turns, multisine, steps}, 30.0, viscousAsymmetry},
          {"stribeck", any, {ramps, multisine, ramps, steps}, 30.0, stribeck},
          {"presliding", any, {ramps, reversals, ramps, multisine}, 30.0, presliding},
          {"quadratic_drag", any, {turns, multisine, heavy}, 30.0, quadraticDrag},
          {"position_dependent_friction", rotary, {turns, multisine, turns}, 30.0, frictionOverAngle},
          {"position_dependent_viscous", rotary, {turns, turns, multisine}, 35.0, viscousOverAngle},
          {"load_dependent_friction", any, {reversals, chirp, heavy, turns}, 30.0, loadFriction},
          {"friction_warmup", any, {multisine, turns}, 45.0, warmup},
          {"rising_stiction", any, {rests, rests, multisine}, 50.0, risingStiction}};
}

}  // namespace breakaway
