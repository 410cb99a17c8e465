// The controller that measurements run with; on a linear axis with how fast it may go between its ends.
#include <algorithm>

#include "base/numbers.h"
#include "commission/motor_tests.h"
#include "commission/steps.h"
#include "commission/travel_plan.h"
#include "control/tuning.h"
#include "experiment/servo_settings.h"

namespace breakaway {

namespace {

constexpr double velocityPart = 0.15, positionPart = 0.1;  // of the speed filter's bandwidth

/// What gains are made from; with m for rad, kg for kg m² and N for Nm on a linear axis.
struct Movable {
  double inertia = 0.0, perAmpere = 0.0, count = 0.0;
};

/// How much slower than the filter alone allows, 1 or less: a coarse encoder's count is a leap of the speed by the
/// count times the filter's bandwidth, and gains that answer it with more than the current's limit swing to and fro.
double slowedBy(const Movable& what, double filter, double cutoff, double limit_A) {
  const double answer_A = what.inertia * (velocityPart * filter + cutoff) * what.count * filter / what.perAmpere;
  return answer_A > limit_A && limit_A > 0.0 ? limit_A / answer_A : 1.0;
}

ControllerSettings carefullyTuned(const Movable& what, double tick_s, const ControllerSettings& present) {
  // A faster observer than the board's own isn't made use of, but a slower one asks for slower loops.
  const double own = boardVelocityBandwidth_rad_per_s(tick_s), set = present.velocity_bandwidth_rad_per_s;
  const double filter = set > 0.0 ? std::min(set, own) : own, cutoff = tuneObserver(tick_s, filter);
  const double slowed = slowedBy(what, filter, cutoff, present.current_limit_A);
  const double velocity = slowed * velocityPart * filter, position = slowed * positionPart * filter;
  return withTuning(present, {tuneMotion(what.inertia, what.perAmpere, velocity, position), slowed * cutoff,
                              what.inertia, what.perAmpere});
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
    const double counts = known.identity.countsPerRev;
    const Movable what{motor.inertia_kg_m2.value, motor.torquePerShownAmpere_Nm(),
                       counts > 0.0 ? (known.linear() ? 1.0 : turn_rad) / counts : 0.0};
    ControllerSettings careful = carefullyTuned(what, 1.0 / known.identity.loopRate_Hz, on.drive.settings());
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
