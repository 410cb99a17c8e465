#include <cmath>

#include "trial/trial_effect_tables.h"

namespace breakaway {

namespace {

using enum TrialMove;

Concealed coulombAsymmetry(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const double difference = drawnSign(random) * size * drawn(random, 0.3, 0.7) * rig.coulomb();
  addCoulombAsymmetry(rig.physics, difference);
  return {"coulomb_asymmetry", {{torqueNamed("difference", rig), difference}}};
}

Concealed viscousAsymmetry(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const double difference = drawnSign(random) * size * drawn(random, 0.02, 0.05) * rig.peakTorque / rig.topSpeed;
  rig.raiseViscous(0.6 * std::abs(difference));
  addViscousAsymmetry(rig.physics, difference);
  return {"viscous_asymmetry", {{viscousNamed("difference", rig), difference}}};
}

Concealed stribeck(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  PlantPhysics& p = rig.physics;
  const double excess = size * drawn(random, 0.35, 0.8) * rig.coulomb();
  addStribeckExcess(p, excess);
  p.stribeckVelocity = drawnLog(random, 0.03, 0.12) * rig.topSpeed;
  p.stribeckExponent = drawn(random, 0.8, 2.0);
  return {"stribeck",
          {{torqueNamed("excess", rig), excess},
           {speedNamed("velocity", rig), p.stribeckVelocity},
           {"exponent", p.stribeckExponent}}};
}

/// The travel over which friction builds up grows with the size.
Concealed presliding(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  auto& bristles = rig.physics.bristles;
  const double full = rig.axis == Axis::rotary ? 0.06 : 1e-3;
  const double travel = std::max(6.0 * rig.sensors.count, size * drawnLog(random, 0.4, 1.5) * full);
  bristles.stiffness = rig.coulomb() / travel;
  bristles.damping = 2.0 * drawn(random, 0.2, 0.5) * std::sqrt(bristles.stiffness * rig.physics.inertia);
  return {"presliding",
          {{stiffnessNamed("stiffness", rig), bristles.stiffness},
           {viscousNamed("bristle_damping", rig), bristles.damping}}};
}

Concealed quadraticDrag(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  double& coefficient = rig.physics.quadraticDrag;
  coefficient = size * drawn(random, 0.05, 0.15) * rig.peakTorque / (rig.topSpeed * rig.topSpeed);
  return {"quadratic_drag",
          {{rig.axis == Axis::rotary ? "coefficient_Nm_s2_per_rad2" : "coefficient_N_s2_per_m2", coefficient}}};
}

Concealed frictionOverAngle(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const Harmonic wave = drawnWave(size * drawn(random, 0.25, 0.55) * rig.coulomb(), 1, 6, random);
  addFrictionOverAngle(rig.physics, {wave.order, wave.amplitude / rig.coulomb(), wave.phase_rad});
  return {"position_dependent_friction", waveTruth(torqueNamed("amplitude", rig), wave)};
}

Concealed viscousOverAngle(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const Harmonic wave = drawnWave(size * drawn(random, 0.02, 0.05) * rig.peakTorque / rig.topSpeed, 1, 6, random);
  rig.raiseViscous(1.1 * wave.amplitude);
  addViscousOverAngle(rig.physics, {wave.order, wave.amplitude / rig.viscous(), wave.phase_rad});
  return {"position_dependent_viscous", waveTruth(viscousNamed("amplitude", rig), wave)};
}

Concealed loadFriction(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  rig.physics.ofLoad = size * drawn(random, 0.08, 0.18);
  return {"load_dependent_friction", {{"coefficient", rig.physics.ofLoad}}};
}

Concealed warmup(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  auto& warmup = rig.physics.warmup;
  warmup.excess = size * drawn(random, 0.6, 1.2) * rig.coulomb();
  warmup.time_s = drawn(random, 6.0, 18.0);
  return {"friction_warmup", {{torqueNamed("amplitude", rig), warmup.excess}, {"time_constant_s", warmup.time_s}}};
}

Concealed risingStiction(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  auto& rest = rig.physics.rest;
  rest.excess = size * drawn(random, 1.0, 2.2) * rig.coulomb();
  rest.time_s = drawnLog(random, 0.3, 1.5);
  rest.travel_rad = 3.0 * rig.sensors.count;
  return {"rising_stiction", {{torqueNamed("excess", rig), rest.excess}, {"time_constant_s", rest.time_s}}};
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
