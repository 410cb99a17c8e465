// The rig of a sealed trial: a drawn motor with its drive, sensors and loop.
#pragma once

#include <optional>

#include "base/statistics.h"
#include "motor/bench.h"
#include "plant/plant.h"

namespace breakaway {

/// Uniform, and uniform in the logarithm, between two bounds; either sign with even chances.
double drawn(Random& random, double low, double high);
double drawnLog(Random& random, double low, double high);
double drawnSign(Random& random);

/// What the sensors do to what the plant does.
struct TrialSensors {
  double countsPerUnit = 4096.0;  ///< per rev or per m
  double count = 0.0;             ///< rad or m; the encoder floors to it
  double row_s = 1e-3;
  bool current = false;         ///< the current is recorded
  double currentNoise_A = 0.0;  ///< rms
  double currentStep_A = 1e-6;  ///< of the converter
  double currentOffset_A = 0.0;
  double currentSkew_s = 0.0;  ///< how late the current is sampled against its row
  Harmonic eccentricity;       ///< rad that the encoder shows too much
};

/// The loop that makes the motor follow its course.
struct TrialLoop {
  ControlMode mode = ControlMode::velocity;
  double bandwidth_rad_per_s = 30.0;
  double observerCutoff_rad_per_s = 0.0;  ///< 0: no disturbance observer
};

struct TrialRig {
  Axis axis = Axis::rotary;
  DriveInput input = DriveInput::current;
  PlantPhysics physics;
  TrialSensors sensors;
  TrialLoop loop;
  std::optional<Pendulum> pendulum;  ///< its inertia is part of the physics' whole
  double supply_V = 24.0;
  double peakTorque = 1.0;   ///< Nm or N that the drive gives for short
  double topSpeed = 1.0;     ///< rad/s or m/s that the course uses at most
  bool shortTravel = false;  ///< the course keeps coming back to where it began

  bool electrical() const { return physics.electrical; }
  /// What the friction is without anything concealed, by viscous effects apart.
  double coulomb() const { return physics.coulomb[0].mean; }
  double viscous() const { return physics.viscous[0].mean; }
  void setFriction(double coulomb, double viscous);
  void raiseViscous(double by);
  double peakCurrent_A() const { return peakTorque / physics.torqueConstant; }
};

/// What the declared pendulum's weight does to the motor, Nm.
Harmonic weightOf(const Pendulum& pendulum);

/// What a trial asks of its rig beyond chance.
struct TrialNeeds {
  bool electrical = false;   ///< voltage or duty drives
  bool windings = false;     ///< a current flows that the bench knows: not torque
  bool heldTorque = false;   ///< current or torque drives
  bool currentSeen = false;  ///< voltage or duty drives and the current is recorded
  bool rotary = false;
  bool noPendulum = false;  ///< one would hide it or hang behind a soft shaft
  bool closedLoop = false;
  bool positionLoop = false;
  bool masked = false;  ///< disturbance observer, stiff loop
  bool noisy = false;   ///< coarse encoder or noisy current
};

/// Draws a rig. Sizes run over a decade and a half of torque; Coulomb friction is 2 to 20 % of the peak torque.
TrialRig drawTrialRig(const TrialNeeds& needs, Random& random);

/// What the technician believes of it: inertia off by up to 30 %, friction by up to a factor of two, resistance by
/// up to 10 %; torque constant, encoder and drive are right; some values are unknown.
Bench believedBench(const TrialRig& rig, Random& random);

}  // namespace breakaway
