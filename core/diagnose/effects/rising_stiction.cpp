#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr int leastStarts = 3;
constexpr double leastRest_rows = 10.0;
constexpr double shortestTime = 0.05;  ///< of the longest rest: what has grown by then at once is no matter of rest

/// Breakaway that grows the longer the axis has stood still; gone as soon as it slides.
class RisingStiction final : public Effect {
 public:
  std::string_view name() const override { return "rising_stiction"; }
  std::string_view formula() const override { return "friction = excess · (1 − exp(−t_rest/T)) · exp(−(ω/ω_s)²)"; }
  std::string_view source() const override {
    return "S. Kato, N. Sato, T. Matsubayashi, 'Some considerations on characteristics of static friction of machine "
           "tool slideway', J. Lubrication Technology 94(3), 1972";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{torqueName("excess", axis), -1e9, 1e9},
            {"time_constant_s", 0.02, 1e6},
            {.name = speedName("velocity", axis), .lower = 1e-9, .upper = 1e9, .amongSpeeds = true}};
  }
  bool growsAtRest() const override { return true; }
  Term term(std::span<const double> p, const Situation& at) const override {
    const double ratio = at.velocity / p[2];
    return {0.0, p[0] * -std::expm1(-at.rest_s / p[1]) * std::exp(-ratio * ratio)};
  }
  Written written(std::span<const double>, Axis) const override {
    return {.friction = "p0 * (1 - exp(-rest_s / p1)) * exp(-(velocity / p2) * (velocity / p2))"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.starts < leastStarts || seen.longestRest_s < leastRest_rows * seen.step_s || seen.highSpeed <= 0.0)
      return shapes;
    for (double rest = 0.1; rest <= 1.5; rest *= 1.7) {
      for (double speed = 0.01; speed <= 0.05; speed *= 1.7)
        shapes.push_back({{0.1 * seen.peakTorque, rest * seen.longestRest_s, speed * seen.highSpeed}});
    }
    return shapes;
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return p[0] > 0.0 && p[0] <= seen.peakTorque && p[1] >= shortestTime * seen.longestRest_s;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "The longer the axis has stood, the {} {} it takes to break away: by up to {}, with a time constant of {}, "
        "gone above {}: a lubricant film that is squeezed out, or a seal that sticks. Look at the seals and the "
        "grease, and expect a jerk after a pause.",
        p[0] < 0.0 ? message("less") : message("more"), torqueWord(seen.axis), frictionText(std::abs(p[0]), seen),
        timeText(p[1]), speedText(2.0 * p[2], seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override {
    return {"stribeck", "presliding", "position_dependent_friction"};
  }
  Message neededExcitation(const Excitation& seen) const override {
    const double rest_s = std::max(seen.longestRest_s, 1.0);
    return message(
        "Stop at one and the same {} at least nine times, rest for {}, {} or {} in turn, and ramp the {} slowly up to "
        "at most {} until it moves.",
        seen.axis == Axis::rotary ? message("angle") : message("position"), timeText(0.05 * rest_s),
        timeText(0.3 * rest_s), timeText(2.0 * rest_s), torqueWord(seen.axis), torqueText(seen.peakTorque, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    const double rest_s = std::clamp(seen.longestRest_s, 1.0, 5.0);
    return startsFromRest(0.2 * seen.highSpeed, {0.05 * rest_s, 0.3 * rest_s, 2.0 * rest_s}, 12);
  }
};

}  // namespace

const Effect& risingStiction() {
  static const RisingStiction effect;
  return effect;
}

}  // namespace breakaway
