#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wave.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Friction that changes around the rotor or along the axis and opposes motion either way.
class PositionDependentFriction final : public Effect {
 public:
  std::string_view name() const override { return "position_dependent_friction"; }
  std::string_view formula() const override { return "friction = A · cos(k θ − φ)"; }
  std::string_view source() const override {
    return "B. Armstrong, 'Friction: experimental determination, modeling and compensation', ICRA 1988, "
           "doi:10.1109/ROBOT.1988.12259";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override { return waveParameters(axis); }
  Term term(std::span<const double> p, const Situation& at) const override { return {0.0, waveValue(p, at)}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    return seen.bothWays ? waveShapes(seen, 1, 12) : std::vector<Shape>{};
  }
  size_t amplitudes() const override { return 2; }
  void columns(const Shape& shape, const Situation& at, std::span<double> out) const override {
    waveColumns(shape, at, at.direction, out);
  }
  Shape shapeOf(std::span<const double> p) const override { return {p[2]}; }
  std::vector<double> fromAmplitudes(const Shape& shape, std::span<const double> amplitude) const override {
    return waveFromAmplitudes(shape, amplitude);
  }
  std::string sentence(std::span<const double> p, const Excitation& seen) const override {
    return "Friction rises and falls by ±" + torqueText(std::abs(p[0]), seen.axis) + ", " + waveText(p[2], seen.axis) +
           ", the same both ways, and is largest first at " + wavePeakText(p, seen.axis) +
           ": look for a bent shaft, a tight seal, or a worn place in the bearing, brush track or screw.";
  }
  std::vector<std::string_view> lookAlikes() const override { return {"cogging", "imbalance"}; }
  std::string neededExcitation(const Excitation& seen) const override {
    return std::string("Run slowly over ") + (seen.axis == Axis::rotary ? "two whole turns" : "the whole travel") +
           " at " + speedText(0.3 * seen.highSpeed, seen.axis) + ", both ways.";
  }
};

}  // namespace

const Effect& positionDependentFriction() {
  static const PositionDependentFriction effect;
  return effect;
}

}  // namespace breakaway
