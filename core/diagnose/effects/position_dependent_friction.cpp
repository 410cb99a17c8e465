#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wave.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Friction that changes around the rotor or along the axis and opposes motion either way.
class PositionDependentFriction final : public WaveEffect {
 public:
  std::string_view name() const override { return "position_dependent_friction"; }
  std::string_view formula() const override { return "friction = A · cos(k θ − φ)"; }
  std::string_view source() const override {
    return "B. Armstrong, 'Friction: experimental determination, modeling and compensation', ICRA 1988, "
           "doi:10.1109/ROBOT.1988.12259";
  }
  Term term(std::span<const double> p, const Situation& at) const override { return {0.0, waveValue(p, at)}; }
  Written written(std::span<const double>, Axis axis) const override {
    return {.friction = waveWritten(axis), .functions = waveFunctions};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    return seen.bothWays ? waveShapes(seen, 1, 12, 0.1 * seen.peakTorque) : std::vector<Shape>{};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    // More than the whole dry friction would push somewhere; the base model may see too little of it.
    return wavePlausible(p, seen, std::max(1.5 * seen.coulomb, 0.2 * seen.peakTorque));
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "Friction is {} higher around {} and as much lower half a wave on, {} and both ways: look there for a worn or "
        "tight place in the bearing, seal, brush track or screw, or a bent shaft.",
        frictionText(std::abs(p[0]), seen), wavePeakText(p, seen.axis, seen.lowest), waveText(p[2], seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"cogging", "imbalance"}; }
  std::vector<Tell> tells() const override {
    return {{"cogging", message("changes sign with direction")},
            {"imbalance", message("changes sign with direction")},
            {"position_dependent_viscous", message("stays the same at every speed")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Run slowly over {} at {}, both ways.",
                   seen.axis == Axis::rotary ? message("two whole turns") : message("the whole travel"),
                   speedText(0.3 * seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return speedsBothWays({0.3 * seen.highSpeed}, twoTurns(seen));
  }
};

}  // namespace

const Effect& positionDependentFriction() {
  static const PositionDependentFriction effect;
  return effect;
}

}  // namespace breakaway
