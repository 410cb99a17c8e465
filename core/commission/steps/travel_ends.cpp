// Both ends of a linear axis, felt for.
#include "commission/steps.h"
#include "experiment/travel_search.h"

namespace breakaway {

namespace {

/// Tried with a current limit that begins at a fiftieth of the controller's.
TravelSearchOptions searchOn(const Identity& board, const ControllerSettings& settings) {
  TravelSearchOptions options;
  options.mostLimit_A = settings.current_limit_A;
  options.firstLimit_A = 0.02 * options.mostLimit_A;
  options.count_m = 1.0 / board.countsPerRev;
  return options;
}

class TravelEnds : public Step {
 public:
  TravelEnds() : Step("ends of the travel", {Known::sensorZero, Known::wiring}, {Known::ends}) {}
  double expected_s(const SweepSettings&) const override { return 20.0; }

  Result<StepRun> begin(OnBench& on) override {
    search_ = std::make_shared<TravelSearch>(searchOn(on.known.identity, on.drive.settings()));
    return StepRun{"02-ends", search_};
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    on.known.counted = search_->travel();
    return StepEnd::over;
  }

 private:
  std::shared_ptr<TravelSearch> search_;
};

}  // namespace

StepPtr travelEndsStep() {
  return std::make_unique<TravelEnds>();
}

}  // namespace breakaway
