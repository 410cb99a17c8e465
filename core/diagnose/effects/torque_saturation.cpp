#include <algorithm>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Iron that saturates: at high current each further ampere gives less torque. Written as a loss, so that no torque
/// turns round however large the current.
class TorqueSaturation final : public Effect {
 public:
  std::string_view name() const override { return "torque_saturation"; }
  std::string_view formula() const override { return "load = β · i² · Kt i"; }
  std::string_view source() const override {
    return "D. Hanselman, 'Brushless Permanent Magnet Motor Design', Magna Physics 2006: saturation of the torque by "
           "the winding's own field; the first odd term after the linear one";
  }
  std::vector<ParameterSpec> parameters(Axis) const override { return {{"coefficient_per_A2", -1e9, 1e9}}; }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {.load_Nm = std::min(p[0] * at.current * at.current, 1.0) * at.driveTorque};
  }
  Written written(std::span<const double>, Axis) const override {
    return {.load = "min(p0 * current * current, 1) * drive"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    if (seen.peakCurrent <= 0.0) return {};  // where torque drives, it is given
    return {Shape{{0.1 / (seen.peakCurrent * seen.peakCurrent)}}};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return p[0] > 0.0 && p[0] * seen.peakCurrent * seen.peakCurrent < 0.7;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "{} falls behind the current when it is high: at {} by {}. The motor's iron saturates there, or the "
        "amplifier's current scale bends: compare with the data sheet's peak current.",
        seen.axis == Axis::rotary ? message("Torque") : message("Force"), quantityText(seen.peakCurrent, "A"),
        percentText(p[0] * seen.peakCurrent * seen.peakCurrent));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"load_dependent_friction", "quadratic_drag"}; }
  std::vector<Tell> tells() const override {
    return {{"load_dependent_friction", message("takes torque away whether it drives or brakes")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Accelerate hard and short, both ways, at {}, {} and {}.", quantityText(0.3 * seen.peakCurrent, "A"),
                   quantityText(0.6 * seen.peakCurrent, "A"), quantityText(seen.peakCurrent, "A"));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    if (!(seen.peakCurrent > 0.0)) return {};
    const Maneuver once = currentPulses({0.3 * seen.peakCurrent, 0.6 * seen.peakCurrent, seen.peakCurrent}, 0.1, 0.5);
    return once + once + once;
  }
  std::string_view drawnOver() const override { return "current"; }
};

}  // namespace

const Effect& torqueSaturation() {
  static const TorqueSaturation effect;
  return effect;
}

}  // namespace breakaway
