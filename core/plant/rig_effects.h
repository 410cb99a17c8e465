// The further physics that a simulated rig can conceal, with the parameters each one takes.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace breakaway {

struct RigEffectKind {
  std::string effect;
  /// Parameter names with the value taken when the rig file leaves them out.
  std::vector<std::pair<std::string, double>> parameters;
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
/// - torque_ripple: Kt · (1 + amplitude · cos(order · θ − phase_rad)).
/// - dead_time: voltage_V lost against the current's direction.
/// - winding_heating: resistance · (1 + share · Θ), Θ a first-order lag with T of i²/current_A².
/// - supply_sag: the bridge's supply falls by resistance_ohm · bridge current.
/// - current_sensor_offset: a further offset_A.
/// - encoder_eccentricity: the encoder shows θ + amplitude_rad · cos(θ − phase_rad).
/// - external_disturbance: torque_Nm from start_s for duration_s.
const std::vector<RigEffectKind>& rigEffectKinds();

}  // namespace breakaway
