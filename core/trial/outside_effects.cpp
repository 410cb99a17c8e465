#include <cmath>
#include <numbers>

#include "trial/trial_effect_tables.h"

namespace breakaway {

namespace {

using enum TrialMove;

/// Friction follows the speed late: more of it while speeding up than while slowing down.
Concealed frictionLag(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  OutsidePhysics& o = rig.physics.outside;
  o.lag = size * drawn(random, 1.0, 2.5) * rig.coulomb() / rig.topSpeed;
  o.lagTime_s = drawnLog(random, 0.15, 0.6);
  return {"friction_lag", {{viscousNamed("slope", rig), o.lag}, {"time_constant_s", o.lagTime_s}}};
}

/// Rms of a torque at random that is more than any rig's own, of which there is up to a twentieth of the friction.
double drawnAtRandom(const TrialRig& rig, double size, Random& random) {
  return size * drawn(random, 0.08, 0.25) * rig.coulomb();
}

/// A torque that wanders at random (Ornstein and Uhlenbeck's process).
Concealed wanderingTorque(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  OutsidePhysics& o = rig.physics.outside;
  o.wander = drawnAtRandom(rig, size, random);
  o.wanderTime_s = drawnLog(random, 0.05, 0.4);
  return {"wandering_torque", {{torqueNamed("rms", rig), o.wander}, {"correlation_time_s", o.wanderTime_s}}};
}

Concealed breathingFriction(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  OutsidePhysics& o = rig.physics.outside;
  o.breathing = size * drawn(random, 0.35, 0.65);
  o.breathingPeriod_s = drawn(random, 3.0, 8.0);
  return {"breathing_friction", {{"swing", o.breathing}, {"period_s", o.breathingPeriod_s}}};
}

/// The transmission swallows small torque; under current or torque drive, where no bridge could do that.
Concealed torqueDeadBand(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  OutsidePhysics& o = rig.physics.outside;
  o.deadBand = size * drawn(random, 0.5, 1.0) * rig.coulomb();
  return {"torque_dead_band", {{torqueNamed("half_width", rig), o.deadBand}}};
}

Concealed frictionBursts(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  OutsidePhysics& o = rig.physics.outside;
  o.burstEvery_s = drawn(random, 1.0, 2.5);
  o.burstLength_s = drawn(random, 0.2, 0.6);
  const double part = o.burstLength_s / (o.burstEvery_s + o.burstLength_s);  // of the time
  o.bursts = drawnAtRandom(rig, size, random) / std::sqrt(part * (1.0 - part));
  return {"friction_bursts",
          {{torqueNamed("height", rig), o.bursts}, {"every_s", o.burstEvery_s}, {"length_s", o.burstLength_s}}};
}

/// A detent that grows with the square of speed.
Concealed whirl(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  OutsidePhysics& o = rig.physics.outside;
  o.whirlSpeed = 0.5 * rig.topSpeed;
  o.whirl = drawnWave(size * drawn(random, 0.04, 0.1) * rig.peakTorque, 2, 5, random);
  return {"whirl", waveTruth(torqueNamed("amplitude_at_half_speed", rig), o.whirl)};
}

/// A detent whose place moves on with speed.
Concealed slippingDetent(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  OutsidePhysics& o = rig.physics.outside;
  o.slippingDetent = drawnWave(size * drawn(random, 0.03, 0.07) * rig.peakTorque, 2, 5, random);
  o.detentSlip_s = drawnSign(random) * drawn(random, 4.0, 8.0) / (0.5 * rig.topSpeed);
  auto truth = waveTruth(torqueNamed("amplitude", rig), o.slippingDetent);
  truth.emplace_back("slip_s", o.detentSlip_s);
  return {"slipping_detent", truth};
}

}  // namespace

const std::vector<TrialEffect>& outsideEffects() {
  static const std::vector<TrialEffect> all = [] {
    TrialNeeds any, rotary, held;
    rotary.rotary = held.heldTorque = true;
    return std::vector<TrialEffect>{{"friction_lag", any, {multisine, steps, reversals}, 30.0, frictionLag},
                                    {"wandering_torque", any, {multisine, turns}, 30.0, wanderingTorque, false},
                                    {"breathing_friction", any, {multisine, reversals, turns}, 30.0, breathingFriction},
                                    {"torque_dead_band", held, {multisine, turns, chirp}, 30.0, torqueDeadBand},
                                    {"friction_bursts", any, {multisine, turns}, 30.0, frictionBursts, false},
                                    {"whirl", rotary, {turns, multisine}, 30.0, whirl},
                                    {"slipping_detent", rotary, {turns, multisine, ramps}, 30.0, slippingDetent}};
  }();
  return all;
}

}  // namespace breakaway
