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
  std::string sentence(std::span<const double> p, const Excitation& seen) const override {
    const double drag = p[0] * seen.highSpeed * seen.highSpeed;
    return "Drag " + std::string(drag < 0.0 ? "falls" : "grows") + " with the square of speed and makes " +
           torqueText(std::abs(drag), seen.axis) + " at " + speedText(seen.highSpeed, seen.axis) +
           ", a quarter of that at " + speedText(0.5 * seen.highSpeed, seen.axis) +
           ": air or oil that is churned. Look at a fan, an open rotor or carriage, or the oil level.";
  }
  std::vector<std::string_view> lookAlikes() const override { return {"torque_saturation", "viscous_asymmetry"}; }
  std::vector<Tell> tells() const override {
    return {{"viscous_asymmetry", "bends upwards with speed, both ways alike"}, {"stribeck", "grows at high speed"}};
  }
  std::string neededExcitation(const Excitation& seen) const override {
    return "Hold constant speeds of " + speedText(seen.highSpeed / 3.0, seen.axis) + ", " +
           speedText(seen.highSpeed * 2.0 / 3.0, seen.axis) + " and " + speedText(seen.highSpeed, seen.axis) +
           " both ways, and let the axis coast down once.";
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
