// A rotor's angle counts from its encoder's index.
#include "experiment/homing.h"

#include <algorithm>

#include "base/numbers.h"
#include "commission/steps.h"
#include "experiment/abilities.h"

namespace breakaway {

namespace {

constexpr double searchCounts_per_s = 150.0, approachCounts_per_s = 50.0, backOffCounts = 10.0;

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
    if (options.countsPerRev > 0.0) {
      // On a coarse encoder as fast that its counts come often, and back far enough to pass a few of them.
      const double count_rad = turn_rad / options.countsPerRev;
      options.searchSpeed_rad_per_s = std::max(options.searchSpeed_rad_per_s, searchCounts_per_s * count_rad);
      options.approachSpeed_rad_per_s = std::max(options.approachSpeed_rad_per_s, approachCounts_per_s * count_rad);
      options.backOff_rad = std::max(options.backOff_rad, backOffCounts * count_rad);
    }
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
