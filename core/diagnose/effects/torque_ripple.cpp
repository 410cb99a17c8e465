#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wave.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Kt that rises and falls around the turn, and the back-EMF alike: Kt·(1 + A·cos(Nθ − φ)). On top of Kt it is a load;
/// Ke = Kt in SI, and Kt is the model's torque per current.
class TorqueRipple final : public WaveEffect {
 public:
  std::string_view name() const override { return "torque_ripple"; }
  std::string_view formula() const override {
    return "load = −A · cos(N θ − φ) · Kt i;  lost voltage = A · cos(N θ − φ) · Ke ω";
  }
  std::string_view source() const override {
    return "T. M. Jahns, W. L. Soong, 'Pulsating torque minimization techniques for permanent magnet AC motor drives—a "
           "review', IEEE Trans. Industrial Electronics 43(2), 1996";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override { return waveParameters("amplitude", axis); }
  bool losesVoltage() const override { return true; }
  Term term(std::span<const double> p, const Situation& at) const override {
    const double wave = waveValue(p, at);
    const double torqueConstant = at.current != 0.0 ? at.driveTorque / at.current : 0.0;
    return {.load_Nm = -wave * at.driveTorque, .voltage_V = wave * torqueConstant * at.velocity};
  }
  Written written(std::span<const double>, Axis axis) const override {
    return {.load = "-" + waveWritten(axis) + " * drive",
            .voltage = waveWritten(axis) + " * torque_constant * velocity",
            .functions = waveFunctions};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    return seen.axis == Axis::rotary ? waveShapes(seen, 1, 48, 0.03) : std::vector<Shape>{};
  }
  bool plausible(std::span<const double> p, const Excitation&) const override { return std::abs(p[0]) < 0.6; }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "The motor's torque per ampere rises and falls by ±{}, {} (largest first at {}): ±{} at the recording's peak, "
        "nothing without current. Look at commutation: the angle of the rotor sensor, a worn brush or commutator, "
        "unequal phases.",
        percentText(std::abs(p[0])), waveText(p[2], seen.axis), wavePeakText(p, seen.axis),
        torqueText(std::abs(p[0]) * seen.peakTorque, seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"cogging", "position_dependent_friction"}; }
  std::vector<Tell> tells() const override {
    return {{"cogging", message("grows with the load")},
            {"position_dependent_viscous", message("grows with the load")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message(
        "Turn two whole turns both ways at {}, once free and once against a load of {}: ripple grows with it.",
        speedText(0.3 * seen.highSpeed, seen.axis), torqueText(0.5 * seen.peakTorque, seen.axis));
  }
};

}  // namespace

const Effect& torqueRipple() {
  static const TorqueRipple effect;
  return effect;
}

}  // namespace breakaway
