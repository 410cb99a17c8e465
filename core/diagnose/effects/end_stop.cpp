#include <algorithm>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double deepest = 0.35;  ///< of the travel: what begins further inside is no end

/// A springy stop at an end of the travel: pushes back in proportion to how far the axis went into it. `side` 1: at
/// growing positions, −1: at falling ones.
class EndStop final : public Effect {
 public:
  std::string_view name() const override { return "end_stop"; }
  std::string_view formula() const override {
    return "load = σ · max(0, k σ (θ − θ₀) + c σ ω) beyond θ₀,  σ = ±1 the side";
  }
  std::string_view source() const override {
    return "K. H. Hunt, F. R. E. Crossley, 'Coefficient of restitution interpreted as damping in vibroimpact', J. "
           "Applied Mechanics 42(2), 1975: contact with a spring and a loss, here both linear";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{stiffnessName("stiffness", axis), 1e-9, 1e12},
            {positionName("start", axis), -1e9, 1e9},
            {"side", -1, 1, true},
            {viscousName("damping", axis), 0.0, 1e12}};
  }
  Term term(std::span<const double> p, const Situation& at) const override {
    const double depth = p[2] * (at.position - p[1]);
    return {.load_Nm = depth > 0.0 ? p[2] * std::max(0.0, p[0] * depth + p[3] * p[2] * at.velocity) : 0.0};
  }
  double longestStep_s(std::span<const double>) const override { return 5e-4; }
  bool mayRepeat(const Excitation&) const override { return true; }
  Written written(std::span<const double>, Axis) const override {
    return {.load = "(p2 * (position - p1) > 0 ? p2 * max(0, p0 * p2 * (position - p1) + p3 * p2 * velocity) : 0)"};
  }
  std::optional<JointShare> joint(std::span<const double> p) const override {
    return JointShare{.stop = JointShare::Stop{p[1], p[2]}, .rest = "its stiffness and damping"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.peakTorque <= 0.0 || seen.travel <= 0.0) return shapes;
    for (const double side : {1.0, -1.0}) {
      const double end = side > 0.0 ? seen.highest : seen.lowest;
      for (const double share : {0.1, 0.06, 0.035, 0.02, 0.012, 0.007, 0.004, 0.002}) {
        const double depth = share * seen.travel;
        if (depth > 2.0 * seen.count)
          shapes.push_back({{0.5 * seen.peakTorque / depth, end - side * depth, side, 0.0}});
      }
    }
    return shapes;
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    const double depth = p[2] > 0.0 ? seen.highest - p[1] : p[1] - seen.lowest;
    return p[0] > 0.0 && depth > 0.0 && depth < deepest * seen.travel;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const double depth = p[2] > 0.0 ? seen.highest - p[1] : p[1] - seen.lowest;
    return message(
        "From {} on, {}, the axis runs into something springy: {}, {} at the furthest point seen, {} further. Look at "
        "that end for a stop, a buffer, a taut cable or a chip in the guide.",
        travelText(p[1], seen.axis), wayText(p[2], seen.axis), stiffnessText(p[0], seen.axis),
        torqueText(p[0] * depth, seen.axis), travelText(depth, seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"imbalance", "position_dependent_friction"}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Move slowly, at most {}, to {} and {} several times, and stay there for a second.",
                   speedText(0.2 * seen.highSpeed, seen.axis), travelText(seen.lowest, seen.axis),
                   travelText(seen.highest, seen.axis));
  }
  std::string_view drawnOver() const override { return "angle"; }
};

}  // namespace

const Effect& endStop() {
  static const EndStop effect;
  return effect;
}

}  // namespace breakaway
