#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// F + d/2 against growing position, F − d/2 against falling position.
class CoulombAsymmetry final : public Effect {
 public:
  std::string_view name() const override { return "coulomb_asymmetry"; }
  std::string_view formula() const override { return "friction = s d/2, on top of F"; }
  std::string_view source() const override {
    return "B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, 'A survey of models, analysis tools and compensation "
           "methods for the control of machines with friction', Automatica 30(7), 1994, section 2";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{torqueName("difference", axis), -1e9, 1e9}};
  }
  Term term(std::span<const double> p, const Situation& at) const override { return {0.0, 0.5 * at.direction * p[0]}; }
  Written written(std::span<const double>, Axis) const override { return {.friction = "0.5 * direction * p0"}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    return seen.bothWays ? std::vector<Shape>{{{0.1 * seen.peakTorque}}} : std::vector<Shape>{};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return 0.5 * std::abs(p[0]) <= seen.peakTorque;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "Dry friction is {} larger {} than the other way: look at brushes, seals or a preloaded bearing. A constant "
        "load or a current offset looks the same in a recording.",
        frictionText(std::abs(p[0]), seen), wayText(p[0], seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"constant_load", "viscous_asymmetry"}; }
  std::string_view twin() const override { return "constant_load"; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Move both ways at {}, and zero the current sensor with the drive off.",
                   speedText(0.5 * seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return speedsBothWays({0.5 * seen.highSpeed}, twoTurns(seen));
  }
  std::string_view drawnOver() const override { return "velocity"; }
};

}  // namespace

const Effect& coulombAsymmetry() {
  static const CoulombAsymmetry effect;
  return effect;
}

}  // namespace breakaway
