#include <cmath>

#include "base/numbers.h"
#include "diagnose/effects/all.h"
#include "diagnose/effects/wave.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double leastTravel_rad = 1.0;  ///< over less a weight looks like a constant load

/// Gravity on a mass off the axis: once per turn, the same whichever way it turns. Positive towards growing angle.
class Imbalance final : public WaveEffect {
 public:
  std::string_view name() const override { return "imbalance"; }
  std::string_view formula() const override { return "load = −A · cos(θ − φ)"; }
  std::string_view source() const override {
    return "L. Meirovitch, 'Fundamentals of Vibrations', McGraw-Hill 2001: rotating unbalanced masses";
  }
  Term term(std::span<const double> p, const Situation& at) const override { return {-waveValue(p, at), 0.0}; }
  bool mayRepeat(const Excitation&) const override { return false; }  // it has one order
  Written written(std::span<const double>, Axis axis) const override {
    return {.load = "-" + waveWritten(axis), .functions = waveFunctions};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    const bool turns = seen.axis == Axis::rotary && seen.travel > leastTravel_rad;
    return turns ? std::vector<Shape>{waveBasis(0.1 * seen.peakTorque, 1)} : std::vector<Shape>{};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return wavePlausible(p, seen, seen.peakTorque);
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    if (isShort(seen)) {
      return message(
          "A torque of up to {} goes with the angle, the same whichever way the axis moves: a weight off the axis, a "
          "spring or a taut cable. Move further, or turn the axis upright, to tell.",
          torqueText(std::abs(p[0]), seen.axis));
    }
    return message(
        "Once per turn a torque of ±{} helps and then hinders, the same whichever way it turns (strongest forward push "
        "at {}): a mass off the axis, or a magnet or core that is out of centre. Balance the load or turn the shaft "
        "upright to tell.",
        torqueText(std::abs(p[0]), seen.axis), wavePeakText(p, seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"cogging", "position_dependent_friction"}; }
  std::vector<Tell> tells() const override {
    return {{"encoder_eccentricity", message("stays the same at every speed")},
            {"position_dependent_friction", message("pushes the same way in both directions")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    if (isShort(seen)) {
      return message("Move slowly to and fro, as far as the axis goes, at {}, and once more with the axis upright.",
                     speedText(0.3 * seen.highSpeed, seen.axis));
    }
    return message("Turn slowly over two whole turns, both ways, at {}.", speedText(0.3 * seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    if (isShort(seen)) return {};  // nobody knows how far it may go
    return speedsBothWays({0.3 * seen.highSpeed}, twoTurns(seen));
  }

 private:
  /// Whether what was seen is a part of a turn, as of a joint between its stops.
  static bool isShort(const Excitation& seen) { return seen.travel > 0.0 && seen.travel < 0.5 * turn_rad; }
};

}  // namespace

const Effect& imbalance() {
  static const Imbalance effect;
  return effect;
}

}  // namespace breakaway
