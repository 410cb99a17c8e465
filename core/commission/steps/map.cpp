// The friction map of a rotor, from its breakaways and its runs at constant speed.
#include <algorithm>

#include "commission/held_beliefs.h"
#include "commission/steps.h"
#include "commission/sweep_layout.h"

namespace breakaway {

namespace {

/// Once the breakaway torques are known, slow runs can be freed of what friction falls by with speed.
Result<void> refitMoving(Commission& known, const MapOptions& options) {
  const auto still = estimateMap(known.breakaways, nullptr, options);
  if (!still) return still.error();
  VelocityFrictionOptions friction = frictionOptions(known);
  for (const MapBin& bin : still->bins) {
    for (size_t w = 0; w < 2; ++w) friction.static_Nm[w].push_back(bin.way[w].static_Nm.value);
  }
  auto moving = fitMovingFriction(known.runs, friction);
  if (!moving) return moving.error();
  known.moving = std::move(*moving);
  const size_t slow = std::max(known.moving[0].leftOut, known.moving[1].leftOut);
  if (slow > 0)
    known.remark("At the slowest " + std::to_string(slow) +
                 " speeds friction still falls with speed; what it has to fall from the breakaway torque was taken off "
                 "before Coulomb and viscous friction were fitted.");
  return {};
}

class Map : public Step {
 public:
  Map() : Step("friction map", {Known::motor, Known::runs, Known::breakaways}, {Known::map}) {}

  Result<StepEnd> end(OnBench& on, const Result<void>&) override {
    Commission& known = on.known;
    const MapOptions options = mapOptions(known, on.options.rig);
    known.events = calibrated(known.breakaways, options);
    if (auto refitted = refitMoving(known, options); !refitted) return refitted.error();
    auto map = estimateMap(known.breakaways, &known.moving, options);
    if (!map) return map.error();
    if (auto held = holdMap(*map, on.options, known); !held) return held.error();
    known.map = std::move(*map);
    known.map.settings = known.howMeasured;
    known.map.remarks = known.contradictions;
    takeAverages(known);
    return StepEnd::over;
  }
};

}  // namespace

StepPtr mapStep() {
  return std::make_unique<Map>();
}

}  // namespace breakaway
