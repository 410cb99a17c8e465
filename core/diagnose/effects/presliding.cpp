#include <algorithm>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Friction that gives like a spring before it slides. The simulation itself builds it up over a reversal, from the
/// whole friction torque and the stiffness.
class Presliding final : public Effect, private ElasticFriction {
  static constexpr double wellDamped = 0.35;  // as bristles are

 public:
  std::string_view name() const override { return "presliding"; }
  std::string_view formula() const override {
    return "friction = F ζ + 2 D √(K J) (ω − |ω| ζ),  dζ/dθ = (K/F) · (1 − s ζ)";
  }
  std::string_view source() const override {
    return "P. R. Dahl, 'Solid friction damping of mechanical vibrations', AIAA Journal 14(12), 1976; damping as in C. "
           "Canudas de Wit, H. Olsson, K. J. Åström, P. Lischinsky, 'A new model for control of systems with "
           "friction', IEEE Trans. Automatic Control 40(3), 1995";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{stiffnessName("stiffness", axis), 1e-9, 1e12}, {"damping_ratio", 0.02, 3.0, true, true}};
  }
  const ElasticFriction* elastic() const override { return this; }
  Written written(std::span<const double>, Axis) const override {
    return {};  // the simulation builds up the whole friction by elastic()
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.reversals + seen.starts < 2 || seen.travel <= 0.0) return shapes;
    const double friction = slidingFriction(seen), widest = widestWay(seen);
    for (double way = seen.count > 0.0 ? seen.count : 1e-4 * seen.travel; way <= widest; way *= 1.7)
      shapes.push_back({{friction / way, wellDamped}});
    return shapes;
  }
  /// The stiffness has no absence at zero: it comes from the grid, whatever the amplitude.
  std::vector<double> scaled(const Shape& shape, std::span<const double>) const override { return shape.front(); }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    const double way = slidingFriction(seen) / p[0];
    return way > 0.3 * seen.count && way < 3.0 * widestWay(seen);
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "After each reversal friction first gives like a spring of {} and reaches its full size only after about {}: "
        "contacts that yield before they slide. Look at seals, brushes and preloaded bearings, and expect creep and "
        "hysteresis when positioning finely.",
        stiffnessText(p[0], seen.axis), travelText(3.0 * slidingFriction(seen) / p[0], seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"stribeck", "backlash", "compliance"}; }
  std::vector<Tell> tells() const override {
    return {{"backlash", message("builds up like a spring against friction")}};
  }
  Message neededExcitation(const Excitation& seen) const override {
    return message(
        "Reverse slowly at least ten times, with the {} rising and falling in ramps up to {} over ways of up to {}.",
        torqueWord(seen.axis), torqueText(std::min(1.5 * slidingFriction(seen), seen.peakTorque), seen.axis),
        travelText(std::max(30.0 * seen.count, widestWay(seen)), seen.axis));
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    if (!(seen.peakCurrent > 0.0 && seen.peakTorque > 0.0)) return {};
    const double sliding = std::min(1.5 * slidingFriction(seen) / seen.peakTorque, 1.0);
    return currentRamps(sliding * seen.peakCurrent, 12, 2.0);
  }
  std::string_view drawnOver() const override { return "travel"; }

 private:
  /// Over which friction may build up, rad; many turns of travel make no contact softer.
  static double widestWay(const Excitation& seen) {
    return std::min(0.05 * seen.travel, seen.axis == Axis::rotary ? 0.5 : 0.01);
  }
  static double slidingFriction(const Excitation& seen) {
    return seen.coulomb > 0.0 ? seen.coulomb : 0.1 * seen.peakTorque;
  }

 private:
  double stiffness(std::span<const double> p) const override { return p[0]; }
  double dampingRatio(std::span<const double> p) const override { return p[1]; }
};

}  // namespace

const Effect& presliding() {
  static const Presliding effect;
  return effect;
}

}  // namespace breakaway
