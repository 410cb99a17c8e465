#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// What a bridge loses to its dead time and its switches' drop: a voltage against the current, whole from a small
/// current on.
class DeadTime final : public Effect {
 public:
  std::string_view name() const override { return "dead_time"; }
  std::string_view formula() const override { return "lost voltage = V · tanh(i/i₀)"; }
  std::string_view source() const override {
    return "S.-G. Jeong, M.-H. Park, 'The analysis and compensation of dead-time effects in PWM inverters', IEEE "
           "Trans. Industrial Electronics 38(2), 1991; its sign of the current, smoothed where ripple crosses zero";
  }
  std::vector<ParameterSpec> parameters(Axis) const override {
    return {{"voltage_V", -1e9, 1e9}, {"current_A", 1e-6, 1e4}};
  }
  bool losesVoltage() const override { return true; }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {.voltage_V = p[0] * std::tanh(at.current / p[1])};
  }
  Written written(std::span<const double>, Axis) const override { return {.voltage = "p0 * tanh(current / p1)"}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (!seen.electrical || seen.peakCurrent <= 0.0) return shapes;
    for (double share = 0.02; share < 0.3; share *= 1.7)
      shapes.push_back({{0.02 * seen.peakInput, share * seen.peakCurrent}});
    return shapes;
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return p[0] > 0.0 && p[0] < 0.3 * seen.peakInput && p[1] < seen.peakCurrent;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "The bridge loses {} against the current's direction ({} of the largest voltage), whole from about {} on: its "
        "dead time or its switches' drop. Look at the dead-time setting, and compensate it by the sign of the current.",
        quantityText(p[0], "V"), percentText(p[0] / seen.peakInput), quantityText(2.0 * p[1], "A"));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"supply_sag", "stribeck"}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Reverse slowly through zero at currents below {}, with the current recorded.",
                   quantityText(0.2 * seen.peakCurrent, "A"));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return throughStandstill(0.1 * seen.highSpeed, 10, 2.0);
  }
  std::string_view drawnOver() const override { return "current"; }
};

}  // namespace

const Effect& deadTime() {
  static const DeadTime effect;
  return effect;
}

}  // namespace breakaway
