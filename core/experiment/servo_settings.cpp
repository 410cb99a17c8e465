#include "experiment/servo_settings.h"

namespace breakaway {

ServoSettings<double> servoSettings(const ControllerSettings& s) {
  return {{s.velocity_kp_A_s_per_rad, s.velocity_ki_A_per_rad, s.velocity_kd_A_s2_per_rad, s.position_kp_A_per_rad,
           s.position_ki_A_per_rad_s, s.position_kd_A_s_per_rad, s.velocity_limit_rad_per_s},
          s.observer_cutoff_rad_per_s,
          s.nominal_inertia_kg_m2,
          s.nominal_torque_constant_Nm_per_A,
          s.current_limit_A};
}

ControllerSettings withTuning(const ControllerSettings& present, const ServoSettings<double>& tuned) {
  const MotionGains<double>& gains = tuned.gains;
  return {gains.velocity_kp_A_s_per_rad,      gains.velocity_ki_A_per_rad,
          gains.velocity_kd_A_s2_per_rad,     gains.position_kp_A_per_rad,
          gains.position_ki_A_per_rad_s,      gains.position_kd_A_s_per_rad,
          tuned.observer_cutoff_rad_per_s,    tuned.inertia_kg_m2,
          tuned.torqueConstant_Nm_per_A,      present.current_limit_A,
          present.velocity_limit_rad_per_s,   present.velocity_bandwidth_rad_per_s,
          present.current_bandwidth_rad_per_s};
}

}  // namespace breakaway
