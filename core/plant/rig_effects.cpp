#include "plant/rig_effects.h"

namespace breakaway {

const std::vector<RigEffectKind>& rigEffectKinds() {
  static const std::vector<RigEffectKind> kinds{
      {"constant_load", {{"torque_Nm", 0.002}}},
      {"imbalance", {{"amplitude_Nm", 0.002}, {"phase_rad", 0.0}}},
      {"cogging", {{"order", 12.0}, {"amplitude_Nm", 0.002}, {"phase_rad", 0.0}}},
      {"coulomb_asymmetry", {{"difference_Nm", 0.002}}},
      {"viscous_asymmetry", {{"difference_Nm_s_per_rad", 1e-5}}},
      {"stribeck", {{"excess_Nm", 0.003}}},
      {"quadratic_drag", {{"coefficient_Nm_s2_per_rad2", 1e-7}}},
      {"position_dependent_friction", {{"order", 1.0}, {"amplitude", 0.2}, {"phase_rad", 0.0}}},
      {"position_dependent_viscous", {{"order", 1.0}, {"amplitude", 0.2}, {"phase_rad", 0.0}}},
      {"friction_warmup", {{"share", 0.2}, {"time_constant_s", 60.0}}},
      {"rising_stiction", {{"share", 0.1}, {"time_constant_s", 1.0}}},
      {"torque_ripple", {{"order", 6.0}, {"amplitude", 0.05}, {"phase_rad", 0.0}}},
      {"dead_time", {{"voltage_V", 0.2}}},
      {"winding_heating", {{"share", 0.3}, {"current_A", 1.0}, {"time_constant_s", 30.0}}},
      {"supply_sag", {{"resistance_ohm", 0.2}}},
      {"current_sensor_offset", {{"offset_A", 0.05}}},
      {"encoder_eccentricity", {{"amplitude_rad", 0.002}, {"phase_rad", 0.0}}},
      {"external_disturbance", {{"torque_Nm", 0.003}, {"start_s", 5.0}, {"duration_s", 1.0}}},
  };
  return kinds;
}

}  // namespace breakaway
