// A linear axis to and fro at several speeds: Coulomb and viscous friction, and the mass once more.
#include <algorithm>
#include <cmath>

#include "commission/steps.h"
#include "commission/sweep_layout.h"
#include "commission/travel_plan.h"
#include "commission/travel_survey.h"
#include "identify/travel_friction.h"

namespace breakaway {

namespace {

// In an order in which speed and time have nothing to do with each other.
constexpr double ownParts[] = {0.2, 0.7, 0.03, 1.0, 0.08, 0.012, 0.45};

void remarkUnsteady(Commission& known) {
  for (const TravelRun& run : known.strokes) {
    if (!tellsOfFriction(run))
      known.remark(message("At {:.3g} m/s the axis sticks and slips; that speed was left out.", run.target_m_per_s));
  }
}

class Strokes : public Step {
 public:
  Strokes()
      : Step("velocity sweep",
             {Known::sensorZero, Known::ends, Known::motor, Known::straight, Known::carefulGains, Known::index},
             {Known::runs}) {}
  double expected_s(const SweepSettings& sweeps) const override {
    const size_t speeds = sweeps.speeds > 0 ? sweeps.speeds : std::size(ownParts);
    return static_cast<double>(speeds) * (1.3 * sweeps.speedRun_s + 2.0);
  }

  Result<StepRun> begin(OnBench& on) override {
    const auto parts = speedParts(ownParts, on.known.sweeps.speeds, 0.012);
    sweep_ = std::make_shared<TravelSweep>(velocitySweepOver(on.known, parts), on.known.strokes);
    before_ = sweep_->runs().size();
    return StepRun{"06-velocity-sweep", sweep_};
  }

  bool gather(Commission& known) override {
    std::vector<TravelRun> strokes = sweep_->runs();
    if (const TravelRun* now = sweep_->underWay()) strokes.push_back(*now);
    const bool more = known.strokes.size() != strokes.size() ||
                      (!strokes.empty() && known.strokes.back().duration_s != strokes.back().duration_s);
    known.strokes = std::move(strokes);
    countFresh(sweep_->zeros(), known.noiseRms_A, before_, known.strokes);
    return more;
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    Commission& known = on.known;
    const ZeroTrack zeros(sweep_->zeros(), known.noiseRms_A);
    known.runsZeroError_A = zeros.at(known.strokes[known.strokes.size() / 2].middle_s).standardError;
    const auto friction = fitTravelFriction(known.strokes, frictionOver(known));
    if (!friction) return friction.error();
    takeTravelFriction(*friction, on.options.bench, known);
    remarkUnsteady(known);
    return StepEnd::over;
  }

 private:
  std::shared_ptr<TravelSweep> sweep_;
  size_t before_ = 0;
};

}  // namespace

StepPtr travelStrokesStep() {
  return std::make_unique<Strokes>();
}

}  // namespace breakaway
