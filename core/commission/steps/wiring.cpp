// Whether motor, encoder and current sensor belong together and to what is believed of them, before anything else
// moves.
#include <algorithm>

#include "base/numbers.h"
#include "commission/held_beliefs.h"
#include "commission/steps.h"
#include "commission/steps/wiring_pulses.h"
#include "experiment/wiring_check.h"

namespace breakaway {

namespace {

constexpr double motion_m = 1e-4, kick_m = 1e-3, own_m = 1e-3;  // of a linear axis
constexpr double wiringCounts = 2.0, kickCounts = 3.0;          // at least, however coarse the encoder is

WiringCheckOptions optionsOn(const OnBench& on) {
  const Identity& board = on.known.identity;
  WiringCheckOptions options;
  options.axis = board.axis;
  options.count_rad = (board.axis == Axis::linear ? 1.0 : turn_rad) / board.countsPerRev;
  options.noise_A = on.known.noiseRms_A;
  options.most_A = on.drive.settings().current_limit_A;
  if (board.axis == Axis::linear) {
    options.motion_rad = motion_m;
    options.kick_rad = kick_m;
    options.own_rad = own_m;
  }
  options.motion_rad = std::max(options.motion_rad, wiringCounts * options.count_rad);
  options.kick_rad = std::max(options.kick_rad, kickCounts * options.count_rad);
  options.own_rad = std::max(options.own_rad, kickCounts * options.count_rad);
  return options;
}

}  // namespace

std::shared_ptr<WiringCheck> wiringCheckOn(const OnBench& on, double coast_s) {
  WiringCheckOptions options = optionsOn(on);
  options.coast_s = coast_s;
  return std::make_shared<WiringCheck>(options);
}

namespace {

class Wiring : public Step {
 public:
  Wiring() : Step("wiring check", {Known::sensorZero}, {Known::wiring}) {}
  double expected_s(const SweepSettings&) const override { return 6.0; }

  Result<StepRun> begin(OnBench& on) override {
    check_ = wiringCheckOn(on);
    return StepRun{"01-wiring", check_};
  }

  Message causeOf(Trip trip) const override { return trip == Trip::contradiction ? check_->evidence() : Message(); }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    on.known.wiring = fitWiring(*check_);
    if (auto held = holdWiring(on.options, on.known); !held) return held.error();
    return StepEnd::over;
  }

 private:
  std::shared_ptr<WiringCheck> check_;
};

}  // namespace

StepPtr wiringStep() {
  return std::make_unique<Wiring>();
}

}  // namespace breakaway
