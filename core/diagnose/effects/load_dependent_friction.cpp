
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// Friction in proportion to the torque that the gear, screw or bearing transmits: all that the motor gives, or what
/// the declared load asks for. The model's torque, never the measured current, whose noise would correlate with the
/// residual.
class LoadDependentFriction final : public Effect {
 public:
  std::string_view name() const override { return "load_dependent_friction"; }
  std::string_view formula() const override { return "friction = μ · |(1 − q) · drive torque + q · known load|"; }
  std::string_view source() const override {
    return "P. Hamon, M. Gautier, P. Garrec, 'Dynamic identification of robots with a dry friction model depending on "
           "load and velocity', IROS 2010, doi:10.1109/IROS.2010.5649189";
  }
  std::vector<ParameterSpec> parameters(Axis) const override {
    return {{"coefficient", -0.9, 0.9},
            {.name = "known_load_part", .lower = 0.0, .upper = 1.0, .held = true, .absentAtZero = true}};
  }
  Term term(std::span<const double> p, const Situation& at) const override {
    return {0.0, p[0] * std::abs((1.0 - p[1]) * at.driveTorque + p[1] * at.knownLoad)};
  }
  Written written(std::span<const double>, Axis) const override {
    return {.friction = "p0 * abs((1 - p1) * drive + p1 * known_load)"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    // Where the torque hardly exceeds dry friction, there is no load whose change could show.
    std::vector<Shape> shapes;
    if (seen.peakTorque > 1.2 * seen.coulomb) shapes.push_back({{0.1, 0.0}});
    if (shapes.empty() && seen.knownLoad > 0.0) shapes.push_back({{0.1, 1.0}});  // or else a variant
    return shapes;
  }
  std::vector<std::vector<double>> asRival(const Excitation& seen) const override {
    return seen.knownLoad > 0.0 ? std::vector<std::vector<double>>{{0.1, 1.0}} : std::vector<std::vector<double>>{};
  }
  std::vector<std::vector<double>> variants(std::span<const double> p, const Excitation& seen) const override {
    // Which of the two torques it is, a regression may mistake.
    return seen.knownLoad > 0.0 ? std::vector<std::vector<double>>{{p[0], 1.0 - p[1]}}
                                : std::vector<std::vector<double>>{};
  }
  bool plausible(std::span<const double> p, const Excitation&) const override { return p[0] > 0.0 && p[0] < 0.95; }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const bool ofKnown = p[1] > 0.5, turns = seen.axis == Axis::rotary;
    const double most = std::abs(p[0]) * (ofKnown ? seen.knownLoad : seen.peakTorque);
    const Message load = ofKnown ? turns ? message("known load's torque") : message("known load's force")
                         : turns ? message("transmitted torque")
                                 : message("transmitted force");
    return message("Friction {} with the {}, by {} of it ({} at {}): losses in the {}",
                   p[0] > 0.0 ? message("grows") : message("falls"), load, percentText(std::abs(p[0])),
                   torqueText(most, seen.axis), ofKnown ? message("its largest") : message("the recording's peak"),
                   turns ? message("gear or the loaded bearing; look at mesh, alignment and grease.")
                         : message("screw or gear; look at nut, alignment and grease."));
  }
  std::vector<std::string_view> lookAlikes() const override {
    return {"torque_saturation", "position_dependent_friction"};
  }
  std::vector<Tell> tells() const override { return {{"torque_saturation", message("only ever resists the motion")}}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message("Repeat the same motion with a known load that asks for at least {}.",
                   torqueText(0.5 * seen.peakTorque, seen.axis));
  }
  std::string_view drawnOver() const override { return "current"; }
};

}  // namespace

const Effect& loadDependentFriction() {
  static const LoadDependentFriction effect;
  return effect;
}

}  // namespace breakaway
