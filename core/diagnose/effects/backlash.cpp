#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/two_mass.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// A load behind a gap: within it the motor turns alone, at its ends teeth meet with stiffness and damping.
class Backlash final : public TwoMassEffect {
 public:
  std::string_view name() const override { return "backlash"; }
  std::string_view formula() const override {
    return "load = k · dz(δ) + c δ' in contact,  dz: what of δ exceeds ±gap/2,  δ'' = ω' − load/J_load";
  }
  std::string_view source() const override {
    return "M. Nordin, P.-O. Gutman, 'Controlling mechanical systems with backlash—a survey', Automatica 38(10), 2002: "
           "the dead-zone model with damped contact that never pulls";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    // Contact lasts less than a few rows: how hard it is shows least, and what bounces off takes part in the rest.
    return {{inertiaName("load", axis), 1e-15, 1e9, false, false, 0.3},
            {positionName("gap", axis), 1e-9, 1e3, false, false, 0.25},
            {stiffnessName("stiffness", axis), 1e-9, 1e12, false, false, 1.0},
            {"damping_ratio", 0.0, 2.0, true}};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.inertia <= 0.0 || seen.step_s <= 0.0 || seen.reversals < 2) return shapes;
    const double load = 0.4 * seen.inertia;  // its share is the amplitude
    const double smallest = std::max(2.0 * seen.count, 1e-4 * seen.travel);
    const double largest = std::min(0.1 * seen.travel, seen.axis == Axis::rotary ? 0.3 : 0.01);
    const double stiffest = std::min(800.0, 0.6 / seen.step_s);  // rad/s of contact that the rows still show
    for (double gap = smallest; gap <= largest; gap *= 2.0) {
      for (const double frequency : {0.2 * stiffest, 0.5 * stiffest, stiffest})
        shapes.push_back({{load, gap, load * frequency * frequency, 0.3}});
    }
    return shapes;
  }
  /// A heavier load on contact that is stiffer in proportion: the motion within the gap stays the same.
  std::vector<double> scaled(const Shape& shape, std::span<const double> amplitude) const override {
    const std::vector<double>& p = shape.front();
    return {p[0] * amplitude[0], p[1], p[2] * amplitude[0], p[3]};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return plausibleLoad(p[0], seen) && p[1] < seen.travel;
  }
  /// Harder contact than smoothed velocities show.
  std::vector<std::vector<double>> variants(std::span<const double> p, const Excitation&) const override {
    return {{p[0], p[1], 4.0 * p[2], p[3]}, {p[0], 0.75 * p[1], 10.0 * p[2], p[3]}};
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const Message counts = seen.count > 0.0 ? message(" ({} counts)", digitsText(p[1] / seen.count)) : Message();
    return message(
        "Behind the motor there is play of {}{}: after each reversal it moves alone that far, then a load of {} ({} of "
        "the inertia) hits. Look at gear, key, coupling or nut: hold the load and turn the motor by hand.",
        travelText(p[1], seen.axis), counts, inertiaText(p[0], seen.axis), percentText(p[0] / seen.inertia));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"presliding", "compliance", "stribeck"}; }
  std::vector<Tell> tells() const override {
    return {{"presliding", message("leaves the motor free before the load hits")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message(
        "Reverse the load at least 20 times: command back and forth with ±{}, and ±{} for reversals at speeds around "
        "{}.",
        digitsText(0.5 * seen.peakInput), digitsText(0.15 * seen.peakInput),
        speedText(0.1 * seen.highSpeed, seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return reversals(0.5 * seen.highSpeed, 20, 0.4) + reversals(0.1 * seen.highSpeed, 10, 1.0);
  }
  std::string_view drawnOver() const override { return "travel"; }

 private:
  std::string loadWritten() const override { return "min(sqrt(max(p2 / p0, 1)), 5000), p3, 0.5 * p1, 0"; }
  TwoMass loadOf(std::span<const double> p) const override {
    const double frequency = std::sqrt(std::max(p[2] / p[0], 1.0));
    return {p[0], std::min(frequency, highestFrequency), p[3], 0.5 * p[1]};
  }
};

}  // namespace

const Effect& backlash() {
  static const Backlash effect;
  return effect;
}

}  // namespace breakaway
