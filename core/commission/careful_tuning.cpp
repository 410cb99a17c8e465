#include "commission/careful_tuning.h"

#include "control/tuning.h"

namespace breakaway {

ControllerSettings carefullyTuned(double inertia, double perAmpere, double tick_s, const ControllerSettings& present) {
  const double filter = boardVelocityBandwidth_rad_per_s(tick_s);
  const auto gains = tuneMotion(inertia, perAmpere, 0.15 * filter, 0.1 * filter);
  ControllerSettings settings = present;
  settings.velocity_kp_A_s_per_rad = gains.velocity_kp_A_s_per_rad;
  settings.velocity_ki_A_per_rad = gains.velocity_ki_A_per_rad;
  settings.velocity_kd_A_s2_per_rad = 0.0;
  settings.position_kp_A_per_rad = gains.position_kp_A_per_rad;
  settings.position_ki_A_per_rad_s = 0.0;
  settings.position_kd_A_s_per_rad = gains.position_kd_A_s_per_rad;
  settings.observer_cutoff_rad_per_s = tuneObserver(tick_s, filter);
  settings.nominal_inertia_kg_m2 = inertia;
  settings.nominal_torque_constant_Nm_per_A = perAmpere;
  return settings;
}

}  // namespace breakaway
