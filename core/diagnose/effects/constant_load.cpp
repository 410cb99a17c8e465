#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

class ConstantLoad final : public Effect {
 public:
  std::string_view name() const override { return "constant_load"; }
  std::string_view formula() const override { return "load = c"; }
  std::string_view source() const override {
    return "A. Janot, M. Gautier, M. Brunot, 'Data Set and Reference Models of EMPS', Nonlinear System Identification "
           "Benchmarks, 2019: the offset of the inverse model";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override { return {{torqueName("load", axis), -1e9, 1e9}}; }
  Term term(std::span<const double> p, const Situation&) const override { return {.load_Nm = p[0]}; }
  Written written(std::span<const double>, Axis) const override { return {.load = "p0"}; }
  std::optional<JointShare> joint(std::span<const double> p) const override { return JointShare{.constantLoad = p[0]}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    // One way only, it is one and the same as the base model's dry friction.
    if (!seen.bothWays || seen.peakTorque <= 0.0) return {};
    return {Shape{{0.1 * seen.peakTorque}}};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return std::abs(p[0]) < 1.5 * seen.peakTorque;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "A constant {} of {} pushes {}, whichever way the axis moves: a tilted or loaded axis, a spring, or an offset "
        "of the current sensor or amplifier. Friction that differs between the two ways looks the same in a recording.",
        torqueText(std::abs(p[0]), seen.axis), torqueWord(seen.axis), wayText(-p[0], seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override {
    return {"coulomb_asymmetry", "viscous_asymmetry", "imbalance"};
  }
  std::string_view twin() const override { return "coulomb_asymmetry"; }
  Message neededExcitation(const Excitation&) const override {
    return message("Move both ways at the same speeds, and zero the current sensor with the drive off.");
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return speedsBothWays({0.5 * seen.highSpeed}, twoTurns(seen));
  }
  std::string_view drawnOver() const override { return "velocity"; }
};

}  // namespace

const Effect& constantLoad() {
  static const ConstantLoad effect;
  return effect;
}

}  // namespace breakaway
