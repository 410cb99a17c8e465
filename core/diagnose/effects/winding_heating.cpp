#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Copper that warms up: its resistance follows its own loss with the winding's thermal lag. Hidden state: Θ in A², the
/// loss in units of the cold resistance.
class WindingHeating final : public Effect, private HiddenState {
 public:
  std::string_view name() const override { return "winding_heating"; }
  std::string_view formula() const override { return "lost voltage = c · Θ · i,  T dΘ/dt = i² (1 + c Θ/R) − Θ"; }
  std::string_view source() const override {
    return "A. Boglietti, A. Cavagnino, D. Staton, M. Shanel, M. Mueller, C. Mejuto, 'Evolution and modern approaches "
           "for thermal analysis of electrical machines', IEEE Trans. Industrial Electronics 56(3), 2009: one lumped "
           "thermal capacity";
  }
  std::vector<ParameterSpec> parameters(Axis) const override {
    // Faster than any winding warms up (the smallest motors' data sheets state a second or more), it would be a voltage
    // that bends with the current.
    return {{"coefficient_ohm_per_A2", -1e9, 1e9}, {"time_constant_s", 0.5, 1e6}};
  }
  bool losesVoltage() const override { return true; }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {.voltage_V = at.memory.empty() ? 0.0 : p[0] * at.memory[0] * at.current};
  }
  const HiddenState* hidden() const override { return this; }
  Written written(std::span<const double>, Axis) const override {
    return {.voltage = "p0 * m0 * current",
            .memory = {"heat_A2"},
            .remember =
                "loss = current * current * max(0, 1 + p0 * m0 / resistance);m0 = m0 + (loss - m0) * (1 - exp(-dt_s / "
                "p1));"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (!seen.electrical || seen.peakCurrent <= 0.0 || seen.duration_s < 4.0) return shapes;
    const double typical = 0.1 * seen.peakInput / std::pow(seen.peakCurrent, 3);
    for (double lag = std::max(2.0, 0.1 * seen.duration_s); lag < 2.0 * seen.duration_s; lag *= 1.7)
      shapes.push_back({{typical, lag}});
    return shapes;
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return p[0] > 0.0 && p[0] * std::pow(seen.usualCurrent, 3) < seen.peakInput;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const double current = 0.5 * seen.peakCurrent;
    return message(
        "The winding warms up and its resistance with it: {} held for long adds {}, over about {}. Compare the "
        "resistance cold and warm; a high rise means poor cooling or too much current.",
        quantityText(current, "A"), quantityText(p[0] * current * current, "Ω"), timeText(p[1]));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"friction_warmup", "supply_sag"}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("From cold, hold {} for {}, then rest as long, and repeat.",
                   quantityText(0.5 * seen.peakCurrent, "A"), timeText(std::max(30.0, 0.5 * seen.duration_s)));
  }
  std::string_view drawnOver() const override { return "time"; }

 private:
  size_t size() const override { return 1; }
  void remember(std::span<const double> p, const Situation& at, double dt_s, std::span<double> memory) const override {
    const double warmth = at.resistance_ohm > 0.0 ? p[0] * at.memory[0] / at.resistance_ohm : 0.0;
    const double loss = at.current * at.current * std::max(0.0, 1.0 + warmth);
    memory[0] = at.memory[0] - (loss - at.memory[0]) * std::expm1(-dt_s / p[1]);
  }
};

}  // namespace

const Effect& windingHeating() {
  static const WindingHeating effect;
  return effect;
}

}  // namespace breakaway
