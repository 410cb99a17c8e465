#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double leastDuration_s = 5.0;  ///< bearings and grease don't warm up in less

/// Dry friction that is higher at the recording's start and settles as grease and bearing warm up.
class FrictionWarmup final : public Effect {
 public:
  std::string_view name() const override { return "friction_warmup"; }
  std::string_view formula() const override { return "friction = A · exp(−t/T)"; }
  std::string_view source() const override {
    return "A. C. Bittencourt, S. Gunnarsson, 'Static friction in a robot joint: modeling and identification of load "
           "and temperature effects', J. Dynamic Systems, Measurement, and Control 134(5), 2012";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{torqueName("amplitude", axis), -1e9, 1e9}, {"time_constant_s", 1e-2, 1e6}};
  }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {0.0, p[0] * std::exp(-at.time_s / p[1])};
  }
  Written written(std::span<const double>, Axis) const override { return {.friction = "p0 * exp(-time_s / p1)"}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.duration_s < leastDuration_s) return shapes;
    for (double share = 0.1; share <= 1.5; share *= 1.7)
      shapes.push_back({{0.1 * seen.peakTorque, share * seen.duration_s}});
    return shapes;
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    // What of it settles while it is recorded has to be more than the drift that any rig has.
    return p[0] <= seen.peakTorque && p[0] * -std::expm1(-seen.duration_s / p[1]) > seen.usualWander();
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "At the recording's start friction is {} {} than later and settles with a time constant of {}: {}",
        frictionText(std::abs(p[0]), seen), p[0] > 0.0 ? message("higher") : message("lower"), timeText(p[1]),
        p[0] > 0.0
            ? message("grease and bearings that warm up. Run the axis warm before measuring, or check the grease.")
            : message("something tightens as it warms up. Look at the fit and preload of the bearings."));
  }
  std::vector<std::string_view> lookAlikes() const override {
    return {"winding_heating", "external_disturbance", "stribeck"};
  }
  std::vector<Tell> tells() const override {
    return {{"external_disturbance", message("comes again after a cold start")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message(
        "Let the axis cool down, then run it to and fro at {} for {}, and repeat the same at once while it is warm.",
        speedText(0.5 * seen.highSpeed, seen.axis), timeText(std::max(2.0 * seen.duration_s, 60.0)));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return reversals(0.5 * seen.highSpeed, static_cast<int>(std::clamp(2.0 * seen.duration_s, 60.0, 600.0)), 1.0);
  }
  std::string_view drawnOver() const override { return "time"; }
};

}  // namespace

const Effect& frictionWarmup() {
  static const FrictionWarmup effect;
  return effect;
}

}  // namespace breakaway
