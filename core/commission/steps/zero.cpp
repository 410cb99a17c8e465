// The current sensor's zero and noise, windings open.
#include "commission/steps.h"
#include "experiment/current_zeroing.h"

namespace breakaway {

namespace {

class CurrentZero : public Step {
 public:
  CurrentZero() : Step("current sensor's zero", {}, {Known::sensorZero}) {}
  double expected_s(const SweepSettings&) const override { return 1.1; }

  Result<StepRun> begin(OnBench& on) override {
    CurrentZeroingOptions options;
    options.axis = on.drive.identity().axis;
    if (options.axis == Axis::linear) options.turns_rad = 1e-3;
    zeroing_ = std::make_shared<CurrentZeroing>(options);
    return StepRun{"01-zero", zeroing_};
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    on.known.noiseRms_A = zeroing_->noiseRms_A();
    on.known.sensorZero_A = zeroing_->zero_A();
    return StepEnd::over;
  }

 private:
  std::shared_ptr<CurrentZeroing> zeroing_;
};

}  // namespace

StepPtr currentZeroStep() {
  return std::make_unique<CurrentZero>();
}

}  // namespace breakaway
