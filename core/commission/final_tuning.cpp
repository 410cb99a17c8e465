#include "commission/final_tuning.h"

#include "stability/auto_tuning.h"
#include "stability/bench_loop.h"

namespace breakaway {

Result<ControllerSettings> mediumSettings(const Commission& done, const ControllerSettings& present) {
  Bench bench = done.bench;
  bench.controller.currentLimit_A = present.current_limit_A;
  BoardTiming timing;
  timing.tick_s = 1.0 / done.identity.loopRate_Hz;
  const auto loop = loopOfBench(bench, timing);
  if (!loop) return loop.error();
  // Torques are per ampere as the sensor shows it; its gain is part of the constant's doubt.
  const Estimate& trueConstant = done.motor.torqueConstant_Nm_per_A;
  const double shown = done.motor.torquePerShownAmpere_Nm();
  const Estimate constant{shown, shown * trueConstant.standardError / trueConstant.value};
  AutoTuningOptions options;
  options.noise = {roundingRms_rad(bench.count()), done.noiseRms_A};
  const auto tuning = autoTune(*loop, done.motor.inertia_kg_m2, constant, options);
  if (!tuning) return tuning.error();
  ControllerSettings settings = present;
  const MotionGains<double>& gains = tuning->settings.gains;
  settings.velocity_kp_A_s_per_rad = gains.velocity_kp_A_s_per_rad;
  settings.velocity_ki_A_per_rad = gains.velocity_ki_A_per_rad;
  settings.velocity_kd_A_s2_per_rad = gains.velocity_kd_A_s2_per_rad;
  settings.position_kp_A_per_rad = gains.position_kp_A_per_rad;
  settings.position_ki_A_per_rad_s = gains.position_ki_A_per_rad_s;
  settings.position_kd_A_s_per_rad = gains.position_kd_A_s_per_rad;
  settings.observer_cutoff_rad_per_s = tuning->settings.observer_cutoff_rad_per_s;
  settings.nominal_inertia_kg_m2 = tuning->settings.inertia_kg_m2;
  settings.nominal_torque_constant_Nm_per_A = tuning->settings.torqueConstant_Nm_per_A;
  return settings;
}

void tuneForUse(Drive& drive, Commission& done) {
  const auto medium = mediumSettings(done, done.settings);
  const auto accepted = medium ? drive.configure(*medium) : medium;
  done.tunedForUse = accepted.ok();
  if (accepted) {
    done.settings = *accepted;
  } else {
    done.remarks.push_back("The controller is left as it was for the measurements: " + accepted.error().message() +
                           ".");
  }
  done.bench.controller = controllerOf(done.settings);
}

BenchController controllerOf(const ControllerSettings& settings) {
  return {ControlMode::velocity,
          settings.velocity_kp_A_s_per_rad,
          settings.velocity_ki_A_per_rad,
          settings.velocity_kd_A_s2_per_rad,
          settings.observer_cutoff_rad_per_s,
          settings.nominal_inertia_kg_m2,
          settings.nominal_torque_constant_Nm_per_A,
          settings.current_limit_A};
}

}  // namespace breakaway
