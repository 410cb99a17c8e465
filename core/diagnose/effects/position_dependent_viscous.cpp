#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wave.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Viscous friction that changes around the rotor or along the axis, as the gap of a lubricated fit does.
class PositionDependentViscous final : public Effect {
 public:
  std::string_view name() const override { return "position_dependent_viscous"; }
  std::string_view formula() const override { return "friction = A · cos(k θ − φ) · |ω|"; }
  std::string_view source() const override {
    return "B. J. Hamrock, 'Fundamentals of Fluid Film Lubrication', McGraw-Hill 1994: Petroff's equation, drag in "
           "inverse proportion to the gap";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return waveParameters(viscousName("amplitude", axis), axis);
  }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {0.0, waveValue(p, at) * std::abs(at.velocity)};
  }
  bool mayRepeat(const Excitation& seen) const override { return wavesAreTold(seen); }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    if (seen.highSpeed <= 1.3 * seen.lowSpeed) return {};
    return waveShapes(seen, 1, 12, 0.1 * seen.peakTorque / seen.highSpeed);
  }
  std::vector<double> scaled(const Shape& shape, std::span<const double> amplitude) const override {
    return waveScaled(shape, amplitude);
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return wavePlausible(p, seen, seen.peakTorque / seen.highSpeed);
  }
  std::string sentence(std::span<const double> p, const Excitation& seen) const override {
    return "Friction grows faster with speed around " + wavePeakText(p, seen.axis, seen.lowest) + ", " +
           waveText(p[2], seen.axis) + " and both ways: by ±" + viscousText(std::abs(p[0]), seen.axis) +
           ", which is ±" + torqueText(std::abs(p[0]) * seen.highSpeed, seen.axis) + " at " +
           speedText(seen.highSpeed, seen.axis) + ". Look for a lubricated fit, seal or guide that is tighter there.";
  }
  std::vector<std::string_view> lookAlikes() const override {
    return {"position_dependent_friction", "torque_ripple", "encoder_eccentricity"};
  }
  std::string neededExcitation(const Excitation& seen) const override {
    return std::string("Run over ") + (seen.axis == Axis::rotary ? "ten whole turns" : "the whole travel") +
           " both ways at two constant speeds, " + speedText(0.3 * seen.highSpeed, seen.axis) + " and " +
           speedText(seen.highSpeed, seen.axis) + ".";
  }
  std::string_view drawnOver() const override { return "angle"; }
};

}  // namespace

const Effect& positionDependentViscous() {
  static const PositionDependentViscous effect;
  return effect;
}

}  // namespace breakaway
