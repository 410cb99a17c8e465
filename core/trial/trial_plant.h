// The plant of sealed trials: a motor with whatever physics a trial conceals, integrated finely. Written apart from the
// search and from the simulated bench, so that an error in one of them can't hide in the other.
#pragma once

#include <cstdint>
#include <vector>

#include "base/statistics.h"

namespace breakaway {

/// Amplitude, order and phase of A cos(order·θ − phase).
struct TrialWave {
  double amplitude = 0.0;
  double order = 1.0;
  double phase_rad = 0.0;
};

/// The friction of the motor's side. Torques in Nm, on a linear axis in N; likewise below.
struct TrialFriction {
  double coulomb = 0.0;
  double viscous = 0.0;
  double asymmetry = 0.0;         ///< Coulomb friction growing minus falling
  double viscousAsymmetry = 0.0;  ///< the same of the viscous friction
  double quadratic = 0.0;         ///< Nm s²/rad²
  double stribeckExcess = 0.0;    ///< above Coulomb at standstill
  double stribeckSpeed = 1.0;
  double stribeckExponent = 1.0;
  double stiffness = 0.0;  ///< σ0 of LuGre, Nm/rad; 0: rigid, it sticks exactly
  double damping = 0.0;    ///< σ1 of LuGre, Nm s/rad
  TrialWave overAngle;     ///< Nm
  TrialWave viscousOverAngle;
  double ofLoad = 0.0;  ///< friction per Nm of the motor's torque
  double warmupExcess = 0.0;
  double warmupTime_s = 1.0;
  double restExcess = 0.0;  ///< what a long rest adds to the breakaway
  double restTime_s = 1.0;
  double restTravel = 0.01;  ///< over which that vanishes once it moves, rad
};

/// Physics that the catalogue doesn't hold; a zero amplitude switches each off.
struct TrialOutside {
  double lag = 0.0;  ///< friction follows a lagged speed: Nm s/rad of the speed's change
  double lagTime_s = 0.3;
  double wander = 0.0;  ///< rms of a coloured random torque
  double wanderTime_s = 0.2;
  double breathing = 0.0;  ///< relative swing of the Coulomb friction over a hidden slow oscillation
  double breathingPeriod_s = 5.0;
  double deadBand = 0.0;  ///< torque around zero that the transmission swallows
  double bursts = 0.0;    ///< friction added during random bursts
  double burstEvery_s = 2.0;
  double burstLength_s = 0.4;
  TrialWave whirl;            ///< A cos(kθ − φ)·(ω/whirlSpeed)²
  double whirlSpeed = 1.0;    ///< rad/s
  TrialWave slippingDetent;   ///< A cos(Nθ − φ − detentSlip·ω)
  double detentSlip_s = 0.0;  ///< rad per rad/s
};

/// Everything the plant is made of.
struct TrialPhysics {
  bool electrical = false;  ///< the input is a voltage; else the motor's torque before its losses, Nm
  double torqueConstant = 1.0;
  double resistance_ohm = 1.0;
  double inductance_H = 1e-3;
  double inertia = 1e-4;  ///< of the motor's side
  TrialFriction friction;

  double gravityTorque = 0.0;  ///< of a pendulum held level: declared to the technician, no secret
  double downAngle_rad = 0.0;

  double constantLoad = 0.0;
  TrialWave imbalance, cogging;
  TrialWave ripple;                ///< of the torque constant, relative
  double saturationTorque = 0.0;   ///< torque = S tanh(Kt i/S); 0: none
  double deadTime_V = 0.0;         ///< lost in the bridge
  double deadTimeCurrent_A = 0.1;  ///< over which that changes sign
  double sagResistance_ohm = 0.0;  ///< of the supply; a bridge that brakes feeds nothing back
  double supply_V = 24.0;
  double heatingPerJoule = 0.0;  ///< relative growth of the resistance per J of winding loss
  double heatingTime_s = 1.0;    ///< in which the winding cools

  double loadInertia = 0.0;  ///< behind the shaft; 0: rigid
  double shaftStiffness = 0.0;
  double shaftDamping = 0.0;
  double gap = 0.0;  ///< of the backlash, whole, rad
  bool stops = false;
  double lowStop = 0.0, highStop = 0.0;  ///< rad
  double stopStiffness = 0.0;
  double stopDamping = 0.0;
  double disturbance = 0.0;  ///< torque that opposes growing angle, in a window of time
  double disturbanceStart_s = 0.0;
  double disturbanceLength_s = 0.0;

  double delay_s = 0.0;        ///< of the input
  double inputLimit = 0.0;     ///< clips the input; 0: none
  double inputSlewPerS = 0.0;  ///< limits the input's slope; 0: none
  double processNoise = 0.0;   ///< rms torque noise, drawn anew every 1 ms
  TrialOutside outside;

  double totalInertia() const { return inertia + loadInertia; }
};

/// Integrates the physics at a fixed step. Standing still is exact: below the holding friction the position doesn't
/// change by a bit. Mechanics: explicit midpoint with the acceleration extrapolated; friction sticks and slips by
/// event (Karnopp's idea without its speed band); windings: trapezoidal rule. With friction.stiffness: LuGre, Canudas
/// de Wit et al., "A new model for control of systems with friction", IEEE TAC 40 (1995), eqs. 2–4.
class TrialPlant {
 public:
  TrialPlant(const TrialPhysics& physics, double step_s, std::uint64_t seed);

  /// Advances by `steps` steps under a held input: V, or Nm where the physics isn't electrical.
  void advance(double input, int steps);

  double time_s() const { return static_cast<double>(steps_) * step_s_; }
  double position() const { return position_; }
  double velocity() const { return velocity_; }
  double loadPosition() const { return loadPosition_; }
  double current() const { return current_; }
  /// The torque constant's torque before losses, Nm.
  double driveTorque() const { return driveTorque_; }
  bool standing() const { return velocity_ == 0.0; }
  /// Starts it at another state.
  void set(double position, double velocity, double current);

 private:
  double acting(double input);
  void advanceWindings(double voltage);
  double torqueOfMotor(double torque) const;
  double loadTorque(double position, double velocity) const;
  double slidingFriction(double direction, double position, double velocity) const;
  double shaftTorque() const;
  double gentleFriction(double level);
  void drawDisturbances();
  void slide(double drive, double level, double holding);

  TrialPhysics physics_;
  double step_s_;
  Random random_;
  std::vector<double> inputs_;  ///< ring of past inputs, one per step
  size_t newest_ = 0;
  std::int64_t steps_ = 0;
  int noiseEvery_ = 1;

  double position_ = 0.0, velocity_ = 0.0, acceleration_ = 0.0, current_ = 0.0;
  double loadPosition_ = 0.0, loadVelocity_ = 0.0;
  double bristle_ = 0.0;  ///< LuGre's z, rad
  double heat_ = 0.0;     ///< relative growth of the resistance
  double rest_s_ = 0.0, restLevel_ = 0.0;
  double warmup_ = 1.0;
  double slewed_ = 0.0;
  double driveTorque_ = 0.0;
  double noise_ = 0.0, wander_ = 0.0, burst_s_ = 0.0, laggedSpeed_ = 0.0, breathing_ = 0.0;
};

}  // namespace breakaway
