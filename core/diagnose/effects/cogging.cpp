
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wave.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Torque between magnets and teeth: pushes towards its valleys whichever way the rotor turns. Positive towards growing
/// angle.
class Cogging final : public WaveEffect {
 public:
  std::string_view name() const override { return "cogging"; }
  std::string_view formula() const override { return "load = −A · cos(N θ − φ)"; }
  std::string_view source() const override {
    return "Z. Q. Zhu, D. Howe, 'Influence of design parameters on cogging torque in permanent magnet machines', IEEE "
           "Trans. Energy Conversion 15(4), 2000";
  }
  Term term(std::span<const double> p, const Situation& at) const override { return {-waveValue(p, at), 0.0}; }
  Written written(std::span<const double>, Axis axis) const override {
    return {.load = "-" + waveWritten(axis), .functions = waveFunctions};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    return waveShapes(seen, 2, 96, 0.1 * seen.peakTorque);
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return wavePlausible(p, seen, seen.peakTorque, 1.0);  // a longer wave is any spring's
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const bool turns = seen.axis == Axis::rotary;
    return message(
        "{} is pulled back and forth by ±{}, {}, the same whichever way it moves (strongest forward pull first at {}): "
        "cogging between magnets and teeth. {}",
        turns ? message("The rotor") : message("The slide"), torqueText(std::abs(p[0]), seen.axis),
        waveText(p[2], seen.axis), wavePeakText(p, seen.axis, seen.lowest),
        turns ? message("Compare with the motor: a multiple of its poles or of its slots.")
              : message("Compare with the pitch of its magnets or of its slots."));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"position_dependent_friction", "imbalance"}; }
  std::vector<Tell> tells() const override {
    return {{"torque_ripple", message("stays the same when the load changes")},
            {"position_dependent_friction", message("pushes the same way in both directions")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Run slowly over {} both ways at two speeds, the slower at most {}.",
                   seen.axis == Axis::rotary ? message("two whole turns") : message("the whole travel"),
                   speedText(0.3 * seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return speedsBothWays({0.3 * seen.highSpeed, seen.highSpeed}, twoTurns(seen));
  }
};

}  // namespace

const Effect& cogging() {
  static const Cogging effect;
  return effect;
}

}  // namespace breakaway
