// The rig file: all there is to a simulated rig. Only the plant and the truth may look into it.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/axis.h"
#include "base/result.h"
#include "motor/duty_curve.h"
#include "plant/physics.h"
#include "plant/rig_effects.h"
#include "plant/rig_faults.h"
#include "plant/rig_wiring.h"

namespace breakaway {

struct RigEncoder {
  double countsPerRev = 0.0;
  double indexAngle_rad = 0.0;  ///< the index, counted from where the shaft stands at power-up
  double indexPlace_rad = 0.0;  ///< the same from where angles of the rig are counted: 0 but on a linear axis
  bool hasIndex = true;
  double eccentricity_rad = 0.0, eccentricityPhase_rad = 0.0;  ///< of the disc: adds amplitude · cos(θ − phase)
  double quadratureError_counts = 0.0;  ///< by which the edges within a line are off, amplitude over the line's period
  double indexWidth_counts = 0.0;  ///< half a line, gated with B: 2; seen at its near edge, whichever way one comes
};

struct RigCurrentSensor {
  double sensitivity_V_per_A = 0.185;
  double gainError = 0.0;
  double offset_A = 0.0;
  double drift_A_per_s = 0.0;
  double noiseRms_A = 0.0;
  double supplyDeviation_V = 0.0;  ///< of the sensor's own supply from the converter's reference; ratiometric: half of
                                   ///< it is offset, and the sensitivity grows as the supply does
  double offset_V_per_degC = 0.0, gain_per_degC = 0.0;           ///< with the sensor's temperature
  double temperatureRise_degC = 0.0, temperatureTime_s = 600.0;  ///< of the sensor after power-up, first-order
  int adcBits = 12;
  double adcRange_V = 5.0;
};

struct RigBridge {
  double supply_V = 0.0;
  double deadZoneDuty = 0.0;          ///< |duty| up to this gives no voltage; beyond it the voltage grows from zero
  double pwmSteps = 0.0;              ///< duty resolution 1/pwmSteps; 0: continuous
  double supplyResistance_ohm = 0.0;  ///< the supply falls by it times the bridge's current; the board doesn't see it
  DutyCurve dutyCurve;                ///< beyond the dead zone; unknown: the voltage grows as the duty does
};

/// The travel of a linear axis between its stops. The shaft that stands for it turns once over the whole travel, from 0
/// at the lower stop, so that the rig's curves are over the travel what they are around a rotor.
struct RigTravel {
  double length_m = 0.0, start_m = 0.0;  ///< between the stops; from the lower one to where it stands at power-up
  double stopStiffness_Nm_per_rad = 0.0, stopDamping_Nm_s_per_rad = 0.0;  ///< of the stops, on that shaft
};

struct Rig {
  std::string name;
  Axis axis = Axis::rotary;
  RigTravel travel;  ///< of a linear axis
  double loopRate_Hz = 0.0;
  double torqueConstant_Nm_per_A = 0.0;
  double backEmfConstant_V_s_per_rad = 0.0;
  double resistance_ohm = 0.0;
  double inductance_H = 0.0;
  double inertia_kg_m2 = 0.0;                      ///< with the disc that the file may add to it
  std::array<FrictionCurve, 2> staticFriction_Nm;  ///< indexed by Way: cw, ccw
  std::array<FrictionCurve, 2> coulomb_Nm;
  std::array<FrictionCurve, 2> viscous_Nm_s_per_rad;
  double stribeckVelocity_rad_per_s = 0.0;
  double scatterRms = 0.0;                  ///< of one breakaway to the next, relative
  std::vector<Harmonic> positionTorque_Nm;  ///< positive towards growing angle
  RigEncoder encoder;
  RigCurrentSensor currentSensor;
  RigBridge bridge;
  RigCoupling coupling;
  std::vector<RigEffect> effects;
  std::vector<RigFault> faults;
  std::vector<RigWiring> wiring;

  /// What one rad of the rig's shaft is on its axis: 1 rad, or so many m.
  double unitPerRad() const;
  /// Where the shaft stands at power-up, as the rig's angles are counted.
  double startAngle_rad() const;
};

/// What the rig's plant is made of, with the concealed effects in it; also for the truth, which is taken when warm.
PlantPhysics physicsOf(const Rig& rig);

/// Reads `breakaway.rig/1` strictly: a missing, wrong or unknown field is an error that names the file and the field,
/// and so is a friction curve that falls below zero somewhere around the rotor.
Result<Rig> readRig(const std::string& path);
Result<Rig> readRigText(const std::string& text, const std::string& place);

}  // namespace breakaway
