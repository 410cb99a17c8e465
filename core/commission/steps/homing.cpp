// A rotor's angle counts from its encoder's index.
#include "experiment/homing.h"

#include <algorithm>

#include "base/numbers.h"
#include "commission/steps.h"
#include "experiment/abilities.h"

namespace breakaway {

namespace {

constexpr double searchCounts_per_s = 150.0, approachCounts_per_s = 50.0, backOffCounts = 10.0;
constexpr double turnsRound_s = 1.0;   // that a standing rotor is given to break loose the other way
constexpr double mostPart = 0.3;       // of the speed that the supply leaves without load
constexpr double turnsOfHoming = 6.0;  // more than it takes in all, at the speed of the search

/// Slower, and friction would hold the rotor for longer than that: while it stands, the integral and the disturbance
/// feedback let the current grow by (ki + g·kp)·ω in a second, from what friction takes one way to the other.
double leastSpeed(const Commission& known) {
  const ControllerSettings& gains = known.settings;
  const double growth = gains.velocity_ki_A_per_rad + gains.observer_cutoff_rad_per_s * gains.velocity_kp_A_s_per_rad;
  const double friction_A = std::max(known.expected_A[0], known.expected_A[1]);
  return growth > 0.0 ? 2.0 * friction_A / (growth * turnsRound_s) : 0.0;
}

/// As fast that friction and the encoder's counts let it be controlled, and as slow that the supply reaches it.
void suitSpeeds(const Commission& known, HomingOptions& options) {
  double &search = options.searchSpeed_rad_per_s, &approach = options.approachSpeed_rad_per_s;
  const double least = leastSpeed(known), Ke = known.motor.backEmfConstant_V_s_per_rad.value;
  search = std::max(search, least);
  approach = std::max(approach, least);
  if (options.countsPerRev > 0.0) {
    // On a coarse encoder as fast that its counts come often, and back far enough to pass a few of them.
    const double count_rad = turn_rad / options.countsPerRev;
    search = std::max(search, searchCounts_per_s * count_rad);
    approach = std::max(approach, approachCounts_per_s * count_rad);
    options.backOff_rad = std::max(options.backOff_rad, backOffCounts * count_rad);
  }
  if (Ke > 0.0) {
    const double most = mostPart * known.identity.supply_V / Ke;
    search = std::min(search, most);
    approach = std::min(approach, most);
  }
  options.timeout_s = std::max(options.timeout_s, turnsOfHoming * turn_rad / search);
}

class Home : public Step {
 public:
  /// It runs with careful gains; where the motor can't be identified, with the board's own.
  explicit Home(const Identity& board)
      : Step("homing",
             obstacleTo(Task::identification, board).empty()
                 ? Facts{Known::wiring, Known::motor, Known::straight, Known::carefulGains}
                 : Facts{},
             {Known::index}) {}
  double expected_s(const SweepSettings&) const override { return 8.0; }

  Result<StepRun> begin(OnBench& on) override {
    HomingOptions options;
    options.countsPerRev = on.known.identity.countsPerRev;
    suitSpeeds(on.known, options);
    homing_ = std::make_shared<Homing>(options);
    return StepRun{"04-homing", homing_};
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    on.known.indexAngle_rad = homing_->indexAngle_rad();
    return StepEnd::over;
  }

 private:
  std::shared_ptr<Homing> homing_;
};

}  // namespace

StepPtr homingStep(const Identity& board) {
  return std::make_unique<Home>(board);
}

}  // namespace breakaway
