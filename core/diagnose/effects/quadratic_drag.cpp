#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Turbulent drag of air or oil.
class QuadraticDrag final : public Effect {
 public:
  std::string_view name() const override { return "quadratic_drag"; }
  std::string_view formula() const override { return "friction = c ω²"; }
  std::string_view source() const override {
    return "J. E. Vrancik, 'Prediction of windage power loss in alternators', NASA TN D-4849, 1968";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{axis == Axis::rotary ? "coefficient_Nm_s2_per_rad2" : "coefficient_N_s2_per_m2", -1e9, 1e9}};
  }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {0.0, p[0] * at.velocity * at.velocity};
  }
  Written written(std::span<const double>, Axis) const override { return {.friction = "p0 * velocity * velocity"}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    if (seen.highSpeed <= 2.0 * seen.lowSpeed) return {};
    return {{{0.1 * seen.peakTorque / (seen.highSpeed * seen.highSpeed)}}};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return p[0] > 0.0 && p[0] * seen.highSpeed * seen.highSpeed <= seen.peakTorque;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const double drag = p[0] * seen.highSpeed * seen.highSpeed;
    return message(
        "Drag {} with the square of speed and makes {} at {}, a quarter of that at {}: air or oil that is churned. "
        "Look at a fan, an open rotor or carriage, or the oil level.",
        drag < 0.0 ? message("falls") : message("grows"), torqueText(std::abs(drag), seen.axis),
        speedText(seen.highSpeed, seen.axis), speedText(0.5 * seen.highSpeed, seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"torque_saturation", "viscous_asymmetry"}; }
  std::vector<Tell> tells() const override {
    return {{"viscous_asymmetry", message("bends upwards with speed, both ways alike")},
            {"stribeck", message("grows at high speed")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Hold constant speeds of {}, {} and {} both ways, and let the axis coast down once.",
                   speedText(seen.highSpeed / 3.0, seen.axis), speedText(seen.highSpeed * 2.0 / 3.0, seen.axis),
                   speedText(seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return speedsBothWays({seen.highSpeed / 3.0, seen.highSpeed * 2.0 / 3.0, seen.highSpeed}, twoTurns(seen));
  }
  std::string_view drawnOver() const override { return "velocity"; }
};

}  // namespace

const Effect& quadraticDrag() {
  static const QuadraticDrag effect;
  return effect;
}

}  // namespace breakaway
