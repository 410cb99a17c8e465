// The further physics that a simulated rig can conceal, with the parameters each one takes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plant/physics.h"

namespace breakaway {

/// Concealed physics: an effect's contract name and its parameters by name.
struct RigEffect {
  std::string effect;
  std::vector<std::pair<std::string, double>> parameters;
  double parameter(const std::string& name) const;  ///< precondition: the reader has filled it in
};

struct RigEffectKind {
  std::string effect;
  /// Parameter names with the value taken when the rig file leaves them out.
  std::vector<std::pair<std::string, double>> parameters;
  bool ofAngleAlone = false;  ///< torques that are functions of the angle alone
  bool needsRotor = false;    ///< its units are a rotor's
  /// Puts it into a plant; none for what sits in a sensor.
  void (*conceal)(const RigEffect& effect, PlantPhysics& physics) = nullptr;
};

/// All kinds the plant knows:
/// - constant_load: torque_Nm towards growing angle.
/// - imbalance, cogging: amplitude_Nm · cos(order · θ − phase_rad), order 1 for imbalance.
/// - coulomb_asymmetry, viscous_asymmetry: added to ccw and taken from cw friction, half of it each.
/// - stribeck: excess_Nm on static friction of both ways.
/// - quadratic_drag: coefficient · ω².
/// - position_dependent_friction, position_dependent_viscous: a further relative harmonic on both ways.
/// - friction_warmup: all dry friction · (1 + share · exp(−t/T)).
/// - rising_stiction: static friction · (1 + share · (1 − exp(−t_rest/T))).
/// - torque_ripple: Kt and Ke · (1 + amplitude · cos(order · θ − phase_rad)).
/// - dead_time: voltage_V lost against the current's direction.
/// - winding_heating: resistance · (1 + share · Θ), Θ a first-order lag with T of the winding's loss over what a cold
///   one loses at current_A.
/// - supply_sag: the bridge's supply falls by resistance_ohm · bridge current.
/// - current_sensor_offset: a further offset_A.
/// - encoder_eccentricity: the encoder shows θ + amplitude_rad · cos(θ − phase_rad).
/// - external_disturbance: torque_Nm from start_s for duration_s.
const std::vector<RigEffectKind>& rigEffectKinds();
/// The kind of that name, or none.
const RigEffectKind* findRigEffect(const std::string& effect);

}  // namespace breakaway
