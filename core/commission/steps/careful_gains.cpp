// The controller that measurements run with; on a linear axis with how fast it may go between its ends.
#include "commission/motor_tests.h"
#include "commission/steps.h"
#include "commission/travel_plan.h"
#include "control/tuning.h"

namespace breakaway {

namespace {

/// `inertia` in kg m² or kg, `perAmpere` in Nm/A or N/A.
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

class CarefulGains : public Step {
 public:
  /// A rotor's are set as soon as it turns; a linear axis' pace takes its motor whole.
  explicit CarefulGains(Axis axis)
      : Step("careful gains",
             axis == Axis::linear ? Facts{Known::ends, Known::motor, Known::straight} : Facts{Known::roughMotor},
             {Known::carefulGains}) {}

  Result<StepEnd> end(OnBench& on, const Result<void>&) override {
    Commission& known = on.known;
    // A rotor's are the same each time they are set: from the spin test, as long as that is remembered.
    const bool spun = !known.linear() && known.tests;
    const IdentifiedMotor& motor = spun ? known.tests->rough : known.identified;
    ControllerSettings careful = carefullyTuned(motor.inertia_kg_m2.value, motor.torquePerShownAmpere_Nm(),
                                                1.0 / known.identity.loopRate_Hz, on.drive.settings());
    if (known.linear()) {
      known.pace = paceOf(known);
      careful.velocity_limit_rad_per_s = 0.3 * known.pace.speed_m_per_s;
    }
    if (known.identity.can.takesGains) {
      const auto accepted = on.drive.configure(careful);
      if (!accepted) return accepted.error();
      known.settings = *accepted;
    }
    known.facts.remove({Known::gainsInUse});
    return StepEnd::over;
  }
};

}  // namespace

StepPtr carefulGainsStep(Axis axis) {
  return std::make_unique<CarefulGains>(axis);
}

}  // namespace breakaway
