// What starts a linear axis from standstill, place by place, both ways.
#include "commission/steps.h"
#include "commission/sweep_layout.h"
#include "commission/travel_plan.h"

namespace breakaway {

namespace {

class TravelBreakaways : public Step {
 public:
  TravelBreakaways()
      : Step("breakaway sweep",
             {Known::sensorZero, Known::ends, Known::motor, Known::straight, Known::carefulGains, Known::index,
              Known::runs},
             {Known::breakaways}) {}
  double expected_s(const SweepSettings& sweeps) const override {
    return 1.1 * static_cast<double>(2 * sweeps.bins * sweeps.turns);
  }

  Result<StepRun> begin(OnBench& on) override {
    const auto moving_A = movingCurrent_A(on.known.strokes);
    if (!moving_A) return moving_A.error();
    options_ = breakawaySweepOver(on.known, *moving_A);
    std::vector<BreakawayEvent> earlier = on.known.breakaways;
    for (BreakawayEvent& event : earlier) event.angle_rad += options_.index_m;
    sweep_ = std::make_shared<TravelBreakaway>(options_, earlier);
    before_ = sweep_->events().size();
    return StepRun{"07-breakaway-sweep", sweep_};
  }

  bool gather(Commission& known) override {
    const bool more = known.breakaways.size() != sweep_->events().size();
    known.breakaways = sweep_->events();
    known.missed = sweep_->missed();
    for (BreakawayEvent& event : known.breakaways) event.angle_rad -= options_.index_m;
    countFresh(sweep_->zeros(), known.noiseRms_A, before_, known.breakaways);
    return more;
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    Commission& known = on.known;
    const auto& events = known.breakaways;
    const ZeroTrack zeros(sweep_->zeros(), known.noiseRms_A);
    known.eventsZeroError_A = events.empty() ? 0.0 : zeros.at(events[events.size() / 2].time_s).standardError;
    known.zeroing_s = options_.zeroing_s;
    known.zeroings = sweep_->zeros().size();
    known.howMeasured = settingsOf(options_, known);
    remarkMissed(known);
    return StepEnd::over;
  }

 private:
  TravelBreakawayOptions options_;
  std::shared_ptr<TravelBreakaway> sweep_;
  size_t before_ = 0;
};

}  // namespace

StepPtr travelBreakawaysStep() {
  return std::make_unique<TravelBreakaways>();
}

}  // namespace breakaway
