// What a plant is made of: the motor, its friction, what it carries, and whatever further physics is concealed in it.
#pragma once

#include <array>
#include <vector>

#include "plant/rig_coupling.h"

namespace breakaway {

/// One term amplitude · cos(order · θ − phase), θ from the index.
struct Harmonic {
  double order = 0.0;
  double amplitude = 0.0;  ///< relative to the mean for a friction curve, Nm for the position torque
  double phase_rad = 0.0;

  double at(double angle_rad) const;
  bool operator==(const Harmonic&) const = default;
};

/// (mean · (1 + Σ harmonics) + added) · Π (1 + factor) around the rotor, in Nm, or Nm s/rad for viscous friction.
struct FrictionCurve {
  double mean = 0.0;
  std::vector<Harmonic> harmonics;
  double added = 0.0;
  std::vector<Harmonic> factors;

  double at(double angle_rad) const;
};

/// Physics beyond the diagnosis' catalogue, for trials; a zero amplitude switches each off.
struct OutsidePhysics {
  double noise = 0.0;  ///< rms torque noise, drawn anew every 1 ms
  double lag = 0.0;    ///< friction follows a lagged speed: Nm s/rad of the speed's change
  double lagTime_s = 0.3;
  double wander = 0.0;  ///< rms of a coloured random torque (Ornstein and Uhlenbeck's process)
  double wanderTime_s = 0.2;
  double breathing = 0.0;  ///< relative swing of the Coulomb friction over a hidden slow oscillation
  double breathingPeriod_s = 5.0;
  double deadBand = 0.0;  ///< torque around zero that the transmission swallows
  double bursts = 0.0;    ///< friction added during random bursts
  double burstEvery_s = 2.0;
  double burstLength_s = 0.4;
  Harmonic whirl;             ///< A cos(kθ − φ)·(ω/whirlSpeed)²
  double whirlSpeed = 1.0;    ///< rad/s
  Harmonic slippingDetent;    ///< A cos(Nθ − φ − detentSlip·ω)
  double detentSlip_s = 0.0;  ///< rad per rad/s

  bool operator==(const OutsidePhysics&) const = default;
};

/// Everything a plant is made of. Torques in Nm, angles in rad, or N and m where a shaft stands for a linear axis one
/// to one. Pairs are indexed by Way: cw, ccw. Zero amplitudes switch effects off.
struct PlantPhysics {
  bool electrical = true;  ///< the input is a voltage; else the motor's torque before its losses
  double torqueConstant = 1.0, backEmfConstant = 1.0;
  double resistance_ohm = 1.0, inductance_H = 1e-3;
  double inertia = 1e-4;  ///< of the motor's side
  double startAngle_rad = 0.0;

  std::array<FrictionCurve, 2> holding;  ///< static friction of a fresh breakaway
  std::array<FrictionCurve, 2> coulomb, viscous;
  double stribeckVelocity = 1.0, stribeckExponent = 2.0;
  double scatterRms = 0.0;      ///< of one breakaway to the next, relative
  double sameStand_rad = 1e-4;  ///< asperities that have moved less hold as before: the same standstill
  double quadraticDrag = 0.0;   ///< Nm s²/rad²
  double ofLoad = 0.0;          ///< friction per Nm of the motor's torque
  struct {
    double share = 0.0;   ///< of all dry friction
    double excess = 0.0;  ///< Nm
    double time_s = 1.0;
  } warmup;  ///< what a cold start adds, falling off with time
  struct {
    double share = 0.0;   ///< of static friction; fades with speed as that does
    double excess = 0.0;  ///< Nm; fades over the travel
    double time_s = 1.0, travel_rad = 0.01;
  } rest;  ///< what a long rest adds to the breakaway
  struct {
    double stiffness = 0.0;  ///< σ0, Nm/rad; 0: rigid, it sticks exactly
    double damping = 0.0;    ///< σ1, Nm s/rad
  } bristles;                ///< of LuGre's friction

  double load = 0.0;               ///< constant torque towards growing angle
  std::vector<Harmonic> position;  ///< torque towards growing angle
  std::vector<Harmonic> ripple;    ///< of the torque constant and the back-EMF constant, relative
  double saturationTorque = 0.0;   ///< torque = S·tanh(Kt·i/S)
  double deadTime_V = 0.0;         ///< lost in the bridge against the current's direction
  double deadTimeCurrent_A = 0.0;  ///< over which that changes sign; 0: the diodes hold small voltages at rest
  double supply_V = 24.0;
  double supplyResistance_ohm = 0.0;  ///< the bridge's voltage falls by it times the bus current; braking feeds
                                      ///< nothing back
  double heatingPerJoule = 0.0;       ///< relative growth of the resistance per J of winding loss
  double heatingTime_s = 1.0;         ///< in which the winding cools

  RigCoupling coupling;  ///< to a load behind the shaft
  struct {
    bool present = false;
    double low_rad = 0.0, high_rad = 0.0;
    double stiffness = 0.0, damping = 0.0;
  } stops;  ///< of what the encoder's side carries
  struct {
    double torque = 0.0, start_s = 0.0, duration_s = 0.0;
  } pulse;  ///< once, from outside, towards growing angle
  struct Attached {
    double from_s = 0.0;
    double torque = 0.0;    ///< towards growing angle
    double pendulum = 0.0;  ///< gravity's torque at most, hanging down at startAngle_rad
  };
  std::vector<Attached> attached;  ///< on the motor's shaft, from a time on
  struct Wall {
    double from_s = 0.0, at_rad = 0.0, side = 1.0;  ///< +1: beyond it angles are larger
    double stiffness = 0.0, damping = 0.0;
    bool placed = false;  ///< where it is in the way of what stood or moved at that time
  };
  /// Stops on one side of what the encoder's side carries, from a time on. Where that is beyond one by then, a rotor
  /// meets it at the same place of the next turn, and a linear axis on its way back.
  std::vector<Wall> walls;

  double delay_s = 0.0;          ///< of the input
  double inputLimit = 0.0;       ///< clips the input
  double inputSlew_per_s = 0.0;  ///< limits the input's slope
  OutsidePhysics outside;

  double totalInertia() const { return inertia + coupling.loadInertia_kg_m2; }
};

/// What friction, position torque and torque constant are at one rotor angle; indexed by Way.
struct AngleTorques {
  std::array<double, 2> static_Nm{};
  std::array<double, 2> coulomb_Nm{};
  std::array<double, 2> viscous_Nm_s_per_rad{};
  double position_Nm = 0.0;  ///< towards growing angle; includes a constant load
  double ripple = 1.0;       ///< of the torque constant, relative
};

/// The torques at `angle_rad` from the index, static friction as after a long rest, all when warm. Friction is never
/// below zero.
AngleTorques torquesAt(const PlantPhysics& physics, double angle_rad);

/// The highest harmonic order in the physics, at least 1; how fine a table must be.
int highestOrder(const PlantPhysics& physics);

/// Effects that change more than one number, the same for every plant that conceals them: `difference` is of ccw less
/// cw, `excess` what static friction has above Coulomb friction, a wave is relative to the friction that it modulates.
void addCoulombAsymmetry(PlantPhysics& physics, double difference);
void addViscousAsymmetry(PlantPhysics& physics, double difference);
void addStribeckExcess(PlantPhysics& physics, double excess);
void addFrictionOverAngle(PlantPhysics& physics, const Harmonic& wave);
void addViscousOverAngle(PlantPhysics& physics, const Harmonic& wave);

}  // namespace breakaway
