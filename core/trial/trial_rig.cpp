#include "trial/trial_rig.h"

#include <array>
#include <cmath>
#include <numbers>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr double gravity_m_per_s2 = 9.81;

DriveInput drawInput(const TrialNeeds& needs, Random& random) {
  if (needs.heldTorque) {
    return needs.windings || random.uniform() < 0.65 ? DriveInput::current : DriveInput::torque;
  }
  if (needs.electrical || needs.currentSeen) return random.uniform() < 0.7 ? DriveInput::voltage : DriveInput::duty;
  const double u = random.uniform() * (needs.windings ? 0.85 : 1.0);
  return u < 0.40   ? DriveInput::voltage
         : u < 0.55 ? DriveInput::duty
         : u < 0.85 ? DriveInput::current
                    : DriveInput::torque;
}

void drawMotor(TrialRig& rig, Random& random) {
  PlantPhysics& p = rig.physics;
  const bool rotary = rig.axis == Axis::rotary;
  rig.peakTorque = rotary ? drawnLog(random, 0.05, 1.6) : drawnLog(random, 6.0, 190.0);
  rig.topSpeed = rotary ? drawnLog(random, 15.0, 70.0) : drawnLog(random, 0.2, 0.9);
  rig.supply_V = std::array{12.0, 24.0, 36.0, 48.0}[random.below(4)];
  p.supply_V = rig.supply_V;
  p.torqueConstant = drawn(random, 0.35, 0.55) * rig.supply_V / rig.topSpeed;
  p.backEmfConstant = p.torqueConstant;
  p.resistance_ohm = drawn(random, 0.6, 1.0) * rig.supply_V / rig.peakCurrent_A();
  p.inductance_H = p.resistance_ohm * drawnLog(random, 0.4e-3, 2e-3);
  p.inertia = rig.peakTorque * drawnLog(random, 0.04, 0.12) / rig.topSpeed;
  const double coulomb = rig.peakTorque * drawnLog(random, 0.02, 0.2);
  rig.setFriction(coulomb, rig.peakTorque * drawnLog(random, 0.01, 0.08) / rig.topSpeed);
  p.sameStand_rad = 0.0;
  p.outside.noise = 2e-4 * rig.peakTorque;
}

/// A point mass on an arm that holds 25 to 50 % of the whole inertia, as a bench file declares it.
void hangPendulum(TrialRig& rig, Random& random) {
  const double inertia = drawn(random, 0.25, 0.5) * rig.physics.inertia;
  const double torque = drawn(random, 0.08, 0.2) * rig.peakTorque;
  Pendulum pendulum;
  pendulum.length_m = gravity_m_per_s2 * inertia / torque;
  pendulum.mass_kg = inertia / (pendulum.length_m * pendulum.length_m);
  pendulum.downAngle_rad = drawn(random, -1.5, 1.5);
  rig.pendulum = pendulum;
  rig.physics.position.push_back(weightOf(pendulum));
}

void drawSensors(TrialRig& rig, const TrialNeeds& needs, Random& random) {
  TrialSensors& s = rig.sensors;
  constexpr std::array rates{500.0, 1000.0, 1000.0, 1000.0, 1000.0, 2000.0};
  s.row_s = 1.0 / rates[random.below(rates.size())];
  const bool coarse = needs.noisy && random.uniform() < 0.5;
  if (rig.axis == Axis::rotary) {
    constexpr std::array fine{2000.0, 4000.0, 4096.0, 8192.0, 10000.0, 14400.0, 20000.0};
    constexpr std::array rough{1000.0, 1024.0};
    s.countsPerUnit = coarse ? rough[random.below(rough.size())] : fine[random.below(fine.size())];
    s.count = turn_rad / s.countsPerUnit;
  } else {
    constexpr std::array fine{1e5, 2e5, 5e5, 1e6};
    s.countsPerUnit = coarse ? 4e4 : fine[random.below(fine.size())];
    s.count = 1.0 / s.countsPerUnit;
  }
  s.current = rig.input == DriveInput::current || needs.currentSeen || (rig.electrical() && random.uniform() < 0.5);
  const double range = 1.5 * rig.peakCurrent_A();
  s.currentNoise_A = range * (needs.noisy && !coarse ? drawnLog(random, 5e-3, 15e-3) : drawnLog(random, 1e-3, 4e-3));
  s.currentStep_A = 2.0 * range / (random.uniform() < 0.5 ? 4096.0 : 16384.0);
  // A drive that holds its own current holds what its sensor shows: an offset there is a constant load, hence material.
  s.currentOffset_A = rig.electrical() ? range * 1e-3 * drawn(random, -1.0, 1.0) : 0.0;
}

void drawLoop(TrialRig& rig, const TrialNeeds& needs, Random& random) {
  TrialLoop& loop = rig.loop;
  const double u = random.uniform();
  const bool closed =
      needs.closedLoop || needs.masked || needs.positionLoop || rig.axis == Axis::linear || rig.pendulum.has_value();
  const double openShare = closed ? 0.0 : rig.electrical() ? 0.5 : 0.25;
  if (needs.positionLoop || rig.axis == Axis::linear) {
    loop.mode = ControlMode::position;
  } else {
    loop.mode = u < openShare                              ? ControlMode::openLoop
                : u < openShare + 0.75 * (1.0 - openShare) ? ControlMode::velocity
                                                           : ControlMode::position;
  }
  loop.bandwidth_rad_per_s = drawn(random, 20.0, 45.0) * (needs.masked ? 1.7 : 1.0);
  if (needs.masked) loop.observerCutoff_rad_per_s = drawnLog(random, 100.0, 300.0);
}

}  // namespace

double drawn(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

double drawnLog(Random& random, double low, double high) {
  return low * std::pow(high / low, random.uniform());
}

double drawnSign(Random& random) {
  return random.uniform() < 0.5 ? -1.0 : 1.0;
}

void TrialRig::setFriction(double coulomb, double viscous) {
  for (size_t way = 0; way < 2; ++way) {
    physics.coulomb[way].mean = physics.holding[way].mean = coulomb;
    physics.viscous[way].mean = viscous;
  }
}

void TrialRig::raiseViscous(double by) {
  for (FrictionCurve& curve : physics.viscous) curve.mean += by;
}

Harmonic weightOf(const Pendulum& pendulum) {
  const double torque = pendulum.mass_kg * gravity_m_per_s2 * pendulum.length_m;
  return {1.0, torque, pendulum.downAngle_rad - 0.5 * std::numbers::pi};  // −torque · sin(θ − down)
}

TrialRig drawTrialRig(const TrialNeeds& needs, Random& random) {
  TrialRig rig;
  rig.axis = needs.rotary || random.uniform() < 0.8 ? Axis::rotary : Axis::linear;
  rig.input = drawInput(needs, random);
  rig.physics.electrical = rig.input == DriveInput::voltage || rig.input == DriveInput::duty;
  drawMotor(rig, random);
  if (rig.axis == Axis::rotary && !needs.noPendulum && random.uniform() < 0.1) hangPendulum(rig, random);
  drawSensors(rig, needs, random);
  drawLoop(rig, needs, random);
  rig.shortTravel = needs.positionLoop || rig.axis == Axis::linear;
  return rig;
}

Bench believedBench(const TrialRig& rig, Random& random) {
  const PlantPhysics& p = rig.physics;
  Bench bench;
  bench.name = "trial";
  bench.axis = rig.axis;
  bench.input = rig.input;
  bench.countsPerUnit = rig.sensors.countsPerUnit;
  if (rig.electrical()) bench.supply_V = rig.supply_V;
  MotorBelief& motor = bench.motor;
  const MotorNames& names = motorNames(rig.axis);
  if (rig.input != DriveInput::torque) {
    motor.torqueConstant = p.torqueConstant;
    bench.trusted.insert(names.torqueConstant);
  }
  if (rig.electrical()) {
    motor.backEmfConstant = p.torqueConstant;
    bench.trusted.insert(names.backEmfConstant);
    motor.resistance_ohm = p.resistance_ohm * drawn(random, 0.9, 1.1);
    motor.inductance_H = p.inductance_H;
  }
  double ownInertia = p.totalInertia();
  if (rig.pendulum) {
    bench.pendulum = rig.pendulum;
    bench.pendulum->downAngle_rad += drawn(random, -0.2, 0.2);
    ownInertia -= rig.pendulum->mass_kg * rig.pendulum->length_m * rig.pendulum->length_m;
  }
  const double inertia = ownInertia * drawn(random, 0.7, 1.3);
  const double viscous = rig.viscous() * drawnLog(random, 0.5, 2.0);
  const double coulomb = rig.coulomb() * drawnLog(random, 0.5, 2.0);
  if (random.uniform() < 0.85) motor.inertia = inertia;
  if (random.uniform() < 0.75) motor.viscous = viscous;
  if (random.uniform() < 0.75) motor.coulomb = coulomb;
  return bench;
}

}  // namespace breakaway
