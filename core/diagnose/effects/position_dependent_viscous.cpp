#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wave.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Viscous friction that changes around the rotor or along the axis, as the gap of a lubricated fit does.
class PositionDependentViscous final : public WaveEffect {
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
  Written written(std::span<const double>, Axis axis) const override {
    return {.friction = waveWritten(axis) + " * abs(velocity)", .functions = waveFunctions};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    if (seen.highSpeed <= 1.3 * seen.lowSpeed) return {};
    return waveShapes(seen, 1, 12, 0.1 * seen.peakTorque / seen.highSpeed);
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return wavePlausible(p, seen, seen.peakTorque / seen.highSpeed);
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "Friction grows faster with speed around {}, {} and both ways: by ±{}, which is ±{} at {}. Look for a "
        "lubricated fit, seal or guide that is tighter there.",
        wavePeakText(p, seen.axis, seen.lowest), waveText(p[2], seen.axis), viscousText(std::abs(p[0]), seen.axis),
        torqueText(std::abs(p[0]) * seen.highSpeed, seen.axis), speedText(seen.highSpeed, seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override {
    return {"position_dependent_friction", "torque_ripple", "encoder_eccentricity"};
  }
  std::vector<Tell> tells() const override {
    return {{"position_dependent_friction", message("grows with the speed")},
            {"torque_ripple", message("grows with the speed")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Run over {} both ways at two constant speeds, {} and {}.",
                   seen.axis == Axis::rotary ? message("ten whole turns") : message("the whole travel"),
                   speedText(0.3 * seen.highSpeed, seen.axis), speedText(seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return speedsBothWays({0.3 * seen.highSpeed, seen.highSpeed}, 5.0 * twoTurns(seen));
  }
};

}  // namespace

const Effect& positionDependentViscous() {
  static const PositionDependentViscous effect;
  return effect;
}

}  // namespace breakaway
