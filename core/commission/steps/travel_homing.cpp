// A linear axis' positions count from its encoder's index, or from its lower end where there is none; with that its
// bins lie fast.
#include "commission/steps.h"
#include "commission/travel_plan.h"

namespace breakaway {

namespace {

/// Over the travel between the margins; what was measured before keeps the bins that it began with.
Result<void> layBins(OnBench& on) {
  Commission& known = on.known;
  const double index_m = known.indexAngle_rad.value;
  if (known.travel) {
    const Travel before = moved(*known.travel, index_m);
    if (sameEnds(before, known.counted)) {
      known.counted = before;
    } else if (!on.options.measuresAnew) {
      return Error{"travel", message("ends elsewhere than when the interrupted job was begun, expected the same axis")};
    } else if (!known.strokes.empty()) {
      known.remark(message("The ends lie elsewhere than before: what was measured over the travel is forgotten."));
      known.forget({Known::runs, Known::breakaways});
    }
  }
  known.travel = moved(known.counted, -index_m);
  return {};
}

class TravelHome : public Step {
 public:
  TravelHome() : Step("homing", {Known::ends, Known::motor, Known::straight, Known::carefulGains}, {Known::index}) {}
  double expected_s(const SweepSettings&) const override { return 10.0; }

  Result<StepRun> begin(OnBench& on) override {
    if (!on.known.identity.hasIndex) return StepRun{};
    homing_ = std::make_shared<TravelHoming>(homingOver(on.known));
    return StepRun{"05-homing", homing_};
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    on.known.indexAngle_rad = homing_ ? homing_->index_m() : lowerEnd(on.known);
    if (!homing_) on.known.remark(message("The encoder has no index: positions are counted from the lower end."));
    if (auto laid = layBins(on); !laid) return laid.error();
    return StepEnd::over;
  }

 private:
  std::shared_ptr<TravelHoming> homing_;
};

}  // namespace

StepPtr travelHomingStep() {
  return std::make_unique<TravelHome>();
}

}  // namespace breakaway
