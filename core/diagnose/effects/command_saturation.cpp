#include <algorithm>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double leastCommandPart = 0.3;  ///< of the drive's peak: a higher limit is never below friction

/// A drive that clips what it is told, or follows it no faster than a given rate. Both parameters are in the unit of
/// the drive input (V, A, Nm or N; per second); a rate beyond what a row can ask for limits nothing.
class CommandSaturation final : public Effect, private InputPart {
 public:
  std::string_view name() const override { return "command_saturation"; }
  std::string_view formula() const override { return "|u| ≤ limit,  |du/dt| ≤ slew"; }
  std::string_view source() const override {
    return "K. J. Åström, L. Rundqwist, 'Integrator windup and how to avoid it', American Control Conference 1989: the "
           "actuator model; with a rate limit";
  }
  std::vector<ParameterSpec> parameters(Axis) const override {
    return {{"limit", 1e-9, 1e9}, {"slew_per_s", 1e-9, 1e12}};
  }
  const InputPart* input(DriveInput) const override { return this; }
  Written written(std::span<const double>, Axis) const override {
    return {.memory = {"reached", "has_begun"},
            .input =
                "drive_input = clamp(drive_input, -p0, p0);if (m1 == 0) { m0 = drive_input; m1 = 1; }furthest = p1 * "
                "dt_s;done = clamp(drive_input - m0, -furthest, furthest);drive_input = m0 + done - 0.5 * done * "
                "abs(done) / furthest;m0 = m0 + done;"};
  }
  std::optional<JointShare> joint(std::span<const double> p) const override {
    return JointShare{.inputLimit = p[0], .rest = "how fast the input may change"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.driveMeasured) return shapes;  // what was measured is what the drive gave
    if (seen.byReference || seen.peakInput <= 0.0 || seen.step_s <= 0.0) return shapes;
    const double noRate = 10.0 * seen.peakInput / seen.step_s;
    for (const double share : {0.35, 0.42, 0.5, 0.6, 0.72, 0.85, 0.95})
      shapes.push_back({{share * seen.peakInput, noRate}});
    for (double rise_s = std::max(5e-3, 2.0 * seen.step_s); rise_s < 0.6; rise_s *= 1.7)
      shapes.push_back({{2.0 * seen.peakInput, seen.peakInput / rise_s}});
    return shapes;
  }
  /// Limits don't scale: they are where they are.
  std::vector<double> scaled(const Shape& shape, std::span<const double>) const override { return shape.front(); }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    // A drive that is limited to less than friction would not have moved; a voltage's torque depends on the speed.
    const double torque = p[0] / seen.peakInput * seen.peakTorque;
    if (!seen.electrical && torque < std::min(seen.coulomb, leastCommandPart * seen.peakTorque)) return false;
    return p[0] > 0.0 && p[1] > 0.0 && (p[0] < seen.peakInput || p[1] * seen.step_s < 2.0 * seen.peakInput);
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const char* unit = seen.electrical ? "V" : seen.currentDrive ? "A" : seen.axis == Axis::rotary ? "Nm" : "N";
    Message text = message("The drive gives less than it is told:");
    if (p[0] < seen.peakInput)
      text = text + message(" it clips at {}, {} of the largest command. Look at the amplifier's limits.",
                            quantityText(p[0], unit), percentText(p[0] / seen.peakInput));
    if (p[1] * seen.step_s < 2.0 * seen.peakInput)
      text = text + message(" it takes {} from nothing to the largest command. Look at its ramp or filter setting.",
                            timeText(seen.peakInput / p[1]));
    return text;
  }
  std::vector<std::string_view> lookAlikes() const override { return {"torque_saturation", "transport_delay"}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Step the command to 25, 50, 75 and 100 % of {}, both ways, and record what the drive gives out.",
                   digitsText(seen.peakInput));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    if (!(seen.peakCurrent > 0.0)) return {};
    const double most = seen.peakCurrent;
    const Maneuver once = currentPulses({0.25 * most, 0.5 * most, 0.75 * most, most}, 0.1, 0.5);
    return once + once + once;
  }
  std::string_view drawnOver() const override { return "time"; }

 private:
  void shape(std::span<const double> p, std::span<const double> time_s, std::span<double> input) const override {
    double reached = input.empty() ? 0.0 : std::clamp(input.front(), -p[0], p[0]);
    for (size_t k = 0; k < input.size(); ++k) {
      input[k] = std::clamp(input[k], -p[0], p[0]);
      if (k + 1 == input.size()) break;
      // It climbs within the row: the row gets the mean.
      const double way = input[k] - reached, furthest = p[1] * (time_s[k + 1] - time_s[k]);
      const double done = std::clamp(way, -furthest, furthest);
      input[k] = reached + done - 0.5 * done * std::abs(done) / furthest;
      reached += done;
    }
  }
};

}  // namespace

const Effect& commandSaturation() {
  static const CommandSaturation effect;
  return effect;
}

}  // namespace breakaway
