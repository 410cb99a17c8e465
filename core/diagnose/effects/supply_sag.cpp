#include <algorithm>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double softest = 1.2;  ///< of the winding's own resistance: more than half of the voltage would be lost

/// The supply falls by its resistance times the bridge's current, which is duty times motor current while motoring, and
/// the windings get duty times less. `supply_V` serves only where the supply isn't known; it is then the largest input.
class SupplySag final : public Effect {
 public:
  std::string_view name() const override { return "supply_sag"; }
  std::string_view formula() const override { return "lost voltage = r · (u/supply)² · i while u i > 0"; }
  std::string_view source() const override {
    return "N. Mohan, T. M. Undeland, W. P. Robbins, 'Power Electronics', Wiley 2003, chapter 7: mean input current of "
           "the full-bridge converter";
  }
  std::vector<ParameterSpec> parameters(Axis) const override {
    return {{"resistance_ohm", -1e9, 1e9}, {"supply_V", 1e-3, 1e6, true}};
  }
  bool losesVoltage() const override { return true; }
  Term term(std::span<const double> p, const Situation& at) const override {
    if (at.input * at.current <= 0.0) return {};
    const double duty = at.input / (at.supply_V > 0.0 ? at.supply_V : p[1]);
    return {.voltage_V = p[0] * duty * duty * at.current};
  }
  Written written(std::span<const double>, Axis) const override {
    return {.voltage =
                "(drive_input * current > 0 ? p0 * (drive_input / (supply_V > 0 ? supply_V : p1)) * (drive_input / "
                "(supply_V > 0 ? supply_V : p1)) * current : 0)"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    if (!seen.electrical || seen.peakCurrent <= 0.0 || seen.peakInput <= 0.0) return {};
    const double supply_V = seen.supply_V > 0.0 ? seen.supply_V : seen.peakInput;
    return {Shape{{0.05 * seen.peakInput / seen.peakCurrent, supply_V}}};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    const double duty = std::min(1.0, seen.peakInput / (seen.supply_V > 0.0 ? seen.supply_V : p[1]));
    // At the peak current that a stiff supply would give; a soft one gives less.
    return p[0] > 0.0 && p[0] * duty * duty * seen.peakCurrent < softest * seen.peakInput;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const double beside = p[0] * seen.peakCurrent / seen.peakInput;  // of the winding's resistance
    return message(
        "The supply gives way under load as if it had {} inside: at full voltage and the largest current it lacks "
        "about {}. Look at the supply's current limit, its cable and the bridge's capacitors.",
        quantityText(p[0], "Ω"), quantityText(seen.peakInput * beside / (1.0 + beside), "V"));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"dead_time", "winding_heating"}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Step from {} to {} and back under load, with the supply's voltage recorded.",
                   quantityText(0.5 * seen.peakInput, "V"), quantityText(seen.peakInput, "V"));
  }
};

}  // namespace

const Effect& supplySag() {
  static const SupplySag effect;
  return effect;
}

}  // namespace breakaway
