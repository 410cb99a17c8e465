#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double typical_rad = 2e-3;

/// A code disc off its centre shows too much on one side of the turn and too little on the other.
class EncoderEccentricity final : public Effect, private EncoderPart {
 public:
  std::string_view name() const override { return "encoder_eccentricity"; }
  std::string_view formula() const override { return "shown angle = θ + A · cos(θ − φ)"; }
  std::string_view source() const override {
    return "T. Masuda, M. Kajitani, 'An automatic calibration system for angular encoders', Precision Engineering "
           "11(2), 1989: the first harmonic of the graduation error";
  }
  std::vector<ParameterSpec> parameters(Axis) const override {
    return {{"amplitude_rad", -1e9, 1e9}, {"phase_rad", -1e3, 1e3}};
  }
  const EncoderPart* encoder() const override { return this; }
  Written written(std::span<const double>, Axis) const override {
    return {.shown = "position + p0 * cos(position - p1)"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    if (seen.axis != Axis::rotary || seen.travel < 1.9 * std::numbers::pi) return {};
    return {Shape{{typical_rad, 0.0}, {typical_rad, 0.5 * std::numbers::pi}}};
  }
  std::vector<double> scaled(const Shape& shape, std::span<const double> amplitude) const override {
    return {shape[0][0] * std::hypot(amplitude[0], amplitude[1]), std::atan2(amplitude[1], amplitude[0])};
  }
  bool plausible(std::span<const double> p, const Excitation&) const override { return std::abs(p[0]) < 0.1; }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const double peak = p[0] < 0.0 ? p[1] + std::numbers::pi : p[1];
    const Message counts =
        seen.count > 0.0 ? message(" ({} counts)", digitsText(std::abs(p[0]) / seen.count)) : Message();
    return message(
        "Once per turn the encoder shows up to {}{} too much around {} and as much too little opposite: its disc or "
        "its shaft is off centre. Look at the encoder's seat and the shaft's run-out.",
        travelText(std::abs(p[0]), Axis::rotary), counts, angleText(peak - turn_rad * std::floor(peak / turn_rad)));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"imbalance", "torque_ripple"}; }
  std::vector<Tell> tells() const override { return {{"imbalance", message("grows with the speed's square")}}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message(
        "Turn several turns at constant {} and at {}: the error stays the same, what it takes for acceleration grows "
        "with the speed's square.",
        speedText(0.3 * seen.highSpeed, seen.axis), speedText(seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return speedsBothWays({0.3 * seen.highSpeed, seen.highSpeed}, twoTurns(seen));
  }
  std::string_view drawnOver() const override { return "angle"; }

 private:
  double shown(std::span<const double> p, double position) const override {
    return position + p[0] * std::cos(position - p[1]);
  }
};

}  // namespace

const Effect& encoderEccentricity() {
  static const EncoderEccentricity effect;
  return effect;
}

}  // namespace breakaway
