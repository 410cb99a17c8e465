#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// B + d/2 against growing position, B − d/2 against falling position.
class ViscousAsymmetry final : public Effect {
 public:
  std::string_view name() const override { return "viscous_asymmetry"; }
  std::string_view formula() const override { return "load = d/2 · |ω|, on top of B ω"; }
  std::string_view source() const override {
    return "B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, 'A survey of models, analysis tools and compensation "
           "methods for the control of machines with friction', Automatica 30(7), 1994, section 2: direction-dependent "
           "viscous friction";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{viscousName("difference", axis), -1e9, 1e9}};
  }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {0.5 * p[0] * std::abs(at.velocity), 0.0};
  }
  Written written(std::span<const double>, Axis) const override { return {.drag = "0.5 * p0 * abs(velocity)"}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    return seen.bothWays && seen.highSpeed > 1.3 * seen.lowSpeed
               ? std::vector<Shape>{{{0.1 * seen.peakTorque / seen.highSpeed}}}
               : std::vector<Shape>{};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return 0.5 * std::abs(p[0]) * seen.highSpeed <= seen.peakTorque;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "Friction grows faster with speed {} than the other way, by {}: at {} that is {}. Look at lip seals, lubricant "
        "flow or a fan.",
        wayText(p[0], seen.axis), viscousText(std::abs(p[0]), seen.axis), speedText(seen.highSpeed, seen.axis),
        torqueText(std::abs(p[0]) * seen.highSpeed, seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override {
    return {"constant_load", "coulomb_asymmetry", "stribeck"};
  }
  std::vector<Tell> tells() const override { return {{"quadratic_drag", message("differs between the ways")}}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Move both ways at several constant speeds from {} to {}.",
                   speedText(std::min(seen.lowSpeed, seen.highSpeed / 3.0), seen.axis),
                   speedText(seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    const double low = std::min(seen.lowSpeed, seen.highSpeed / 3.0);
    return speedsBothWays({low, 0.5 * (low + seen.highSpeed), seen.highSpeed}, twoTurns(seen));
  }
  std::string_view drawnOver() const override { return "velocity"; }
};

}  // namespace

const Effect& viscousAsymmetry() {
  static const ViscousAsymmetry effect;
  return effect;
}

}  // namespace breakaway
