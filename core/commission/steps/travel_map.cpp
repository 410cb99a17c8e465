// The friction map of a linear axis, from its breakaways and its strokes.
#include "commission/held_beliefs.h"
#include "commission/steps.h"
#include "commission/sweep_layout.h"
#include "commission/travel_survey.h"

namespace breakaway {

namespace {

class TravelMap : public Step {
 public:
  TravelMap()
      : Step("friction map", {Known::index, Known::motor, Known::runs, Known::breakaways},
             {Known::map, Known::stribeck}) {}

  Result<StepEnd> end(OnBench& on, const Result<void>&) override {
    Commission& known = on.known;
    MapOptions options = mapOptions(known, on.options.rig);
    options.totalVelocity_rad_per_s = travelTotalVelocity_m_per_s;
    known.events = calibrated(known.breakaways, options);
    auto survey = surveyTravel(known, options);
    if (!survey) return survey.error();
    if (auto held = holdMap(survey->map, on.options, known); !held) return held.error();
    takeTravelFriction(survey->friction, on.options.bench, known);
    known.map = std::move(survey->map);
    known.map.settings = known.howMeasured;
    remarkMap(known);
    if (!(known.map.stribeckVelocity_rad_per_s.value > 0.0))
      known.remark(message(
          "Slow strokes don't show over which speed friction falls from static to Coulomb; compensation goes without "
          "static friction."));
    takeAverages(known);
    return StepEnd::over;
  }
};

}  // namespace

StepPtr travelMapStep() {
  return std::make_unique<TravelMap>();
}

}  // namespace breakaway
