// A rotor's angle counts from its encoder's index.
#include "experiment/homing.h"
#include "commission/steps.h"
#include "experiment/abilities.h"

namespace breakaway {

namespace {

class Home : public Step {
 public:
  /// It runs with careful gains; where the motor can't be identified, with the board's own.
  explicit Home(const Identity& board)
      : Step("homing",
             obstacleTo(Task::identification, board).empty() ? Facts{Known::motor, Known::straight, Known::carefulGains}
                                                             : Facts{},
             {Known::index}) {}
  double expected_s(const SweepSettings&) const override { return 8.0; }

  Result<StepRun> begin(OnBench& on) override {
    HomingOptions options;
    options.countsPerRev = on.known.identity.countsPerRev;
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
