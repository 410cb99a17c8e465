#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

double decay(double velocity, double stribeckVelocity, double exponent) {
  const double ratio = std::abs(velocity) / stribeckVelocity;
  return std::exp(exponent == 2.0 ? -ratio * ratio : exponent == 1.0 ? -ratio : -std::pow(ratio, exponent));
}

/// Friction that falls from F + excess at standstill to F, over the Stribeck velocity.
class Stribeck final : public Effect {
 public:
  std::string_view name() const override { return "stribeck"; }
  std::string_view formula() const override { return "friction = excess · exp(−(|ω|/ω_s)^p)"; }
  std::string_view source() const override {
    return "L. C. Bo, D. Pavelescu, 'The friction-speed relation and its influence on the critical velocity of "
           "stick-slip motion', Wear 82(3), 1982";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{torqueName("excess", axis), -1e9, 1e9},
            {.name = speedName("velocity", axis), .lower = 1e-9, .upper = 1e9, .amongSpeeds = true},
            {"exponent", 0.5, 3.0, true, true}};
  }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {0.0, p[0] * decay(at.velocity, p[1], p[2])};
  }
  Written written(std::span<const double> p, Axis) const override {
    if (p[2] == 2.0) return {.friction = "p0 * exp(-(velocity / p1) * (velocity / p1))"};
    if (p[2] == 1.0) return {.friction = "p0 * exp(-abs(velocity) / p1)"};
    return {.friction = "p0 * exp(-pow(abs(velocity) / p1, p2))"};
  }
  std::optional<JointShare> joint(std::span<const double> p) const override {
    if (p[0] <= 0.0) return {};
    return JointShare{.breakaway = p[0], .rest = "over which speed it fades"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.highSpeed <= 0.0) return shapes;
    for (double speed = 0.01 * seen.highSpeed; speed < 0.5 * seen.highSpeed; speed *= 1.7) {
      shapes.push_back({{0.1 * seen.peakTorque, speed, 1.0}});
      shapes.push_back({{0.1 * seen.peakTorque, speed, 2.0}});
    }
    return shapes;
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return p[0] > 0.0 && p[0] <= seen.peakTorque;
  }
  std::vector<std::vector<double>> variants(std::span<const double> p, const Excitation&) const override {
    return {{p[0], p[1], p[2] == 2.0 ? 1.0 : 2.0}};
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message("Near standstill friction is {} {} than in motion and settles over about {}: {}",
                   frictionText(std::abs(p[0]), seen), p[0] > 0.0 ? message("higher") : message("lower"),
                   speedText(p[1], seen.axis),
                   p[0] > 0.0
                       ? message("the Stribeck effect of a lubricated contact. Look at the grease and the preload, and "
                                 "expect stick-slip below that speed.")
                       : message("friction that rises from standstill, as in a full-film or creeping contact."));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"presliding", "backlash", "rising_stiction"}; }
  std::vector<Tell> tells() const override { return {{"quadratic_drag", message("falls with speed near zero")}}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Ramp slowly through zero speed, both ways, from {} down to {}.",
                   speedText(seen.highSpeed / 3.0, seen.axis), speedText(seen.highSpeed / 100.0, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return throughStandstill(seen.highSpeed / 3.0, 10, 4.0);
  }
  std::string_view drawnOver() const override { return "velocity"; }
};

}  // namespace

const Effect& stribeck() {
  static const Stribeck effect;
  return effect;
}

EffectTerm frictionNearStandstill(double excess, double speed, Axis axis) {
  const std::vector<double> values{excess, speed, 2.0};
  EffectTerm term{std::string(stribeck().name()), {}};
  const auto specs = stribeck().parameters(axis);
  for (size_t k = 0; k < specs.size(); ++k) term.parameters.push_back({specs[k].name, values[k], values[k], values[k]});
  return term;
}

}  // namespace breakaway
