// The friction map of a rotor, from its breakaways and its runs at constant speed.
#include <algorithm>
#include <cmath>

#include "commission/held_beliefs.h"
#include "commission/steps.h"
#include "commission/sweep_layout.h"

namespace breakaway {

namespace {

constexpr double worthSaying_rad = 2e-3;

/// Once the breakaway torques are known, slow runs can be freed of what friction falls by with speed.
Result<void> refitMoving(Commission& known, const std::vector<BreakawayEvent>& breakaways, const EncoderDisc& disc,
                         const MapOptions& options) {
  const auto still = estimateMap(breakaways, nullptr, options);
  if (!still) return still.error();
  VelocityFrictionOptions friction = frictionOptions(known);
  friction.disc = disc;
  for (const MapBin& bin : still->bins) {
    for (size_t w = 0; w < 2; ++w) friction.static_Nm[w].push_back(bin.way[w].static_Nm.value);
  }
  auto moving = fitMovingFriction(known.runs, friction);
  if (!moving) return moving.error();
  known.moving = std::move(*moving);
  const size_t slow = std::max(known.moving[0].leftOut, known.moving[1].leftOut);
  if (slow > 0)
    known.remark(message(
        "At {} of the speeds, from the slowest on, friction still falls with speed; what it has to fall from the "
        "breakaway torque was taken off before Coulomb and viscous friction were fitted.",
        slow));
  return {};
}

void remarkDisc(Commission& known, const EncoderDisc& disc) {
  if (disc.unsettled_rad > worthSaying_rad)
    known.remark(message(
        "The speed swings once per turn as if the encoder's disc sat {:.2g} rad off its centre, and yet no such disc "
        "explains it: what the map says of once per turn, and its angles, may be wrong by as much.",
        disc.unsettled_rad));
  const double off_rad = std::abs(disc.off_rad);
  if (off_rad < worthSaying_rad) return;
  known.remark(message(
      "The encoder's disc sits off its centre: it shows angles that are off by up to {:.2g} rad, once per turn. The "
      "map's angles are freed of that; others (a recording's, the board's) aren't.",
      off_rad));
}

class Map : public Step {
 public:
  Map() : Step("friction map", {Known::motor, Known::runs, Known::breakaways}, {Known::map}) {}

  Result<StepEnd> end(OnBench& on, const Result<void>&) override {
    Commission& known = on.known;
    MapOptions options = mapOptions(known, on.options.rig);
    const EncoderDisc disc = fitDisc(known.runs, frictionOptions(known));
    options.angleError_rad = std::hypot(options.angleError_rad, disc.angleError_rad());
    remarkDisc(known, disc);
    std::vector<BreakawayEvent> breakaways = known.breakaways;
    placeBy(disc, breakaways);
    known.events = calibrated(breakaways, options);
    if (auto refitted = refitMoving(known, breakaways, disc, options); !refitted) return refitted.error();
    auto map = estimateMap(breakaways, &known.moving, options);
    if (!map) return map.error();
    if (auto held = holdMap(*map, on.options, known); !held) return held.error();
    known.map = std::move(*map);
    known.map.settings = known.howMeasured;
    remarkMap(known);
    takeAverages(known);
    return StepEnd::over;
  }
};

}  // namespace

StepPtr mapStep() {
  return std::make_unique<Map>();
}

}  // namespace breakaway
