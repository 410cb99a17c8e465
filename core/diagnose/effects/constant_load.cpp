#include <array>

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
           "Benchmarks, 2019: "
           "the offset of the inverse model";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override { return {{torqueName("load", axis), -1e9, 1e9}}; }
  Term term(std::span<const double> p, const Situation&) const override { return {p[0], 0.0}; }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    // One way only, it is one and the same as the base model's dry friction.
    return seen.bothWays ? std::vector<Shape>{{}} : std::vector<Shape>{};
  }
  size_t amplitudes() const override { return 1; }
  void columns(const Shape&, const Situation&, std::span<double> out) const override { out[0] = 1.0; }
  std::vector<double> fromAmplitudes(const Shape&, std::span<const double> amplitude) const override {
    return {amplitude[0]};
  }
  std::string sentence(std::span<const double> p, const Excitation& seen) const override {
    return "A constant " + torqueText(std::abs(p[0]), seen.axis) +
           (seen.axis == Axis::rotary ? " of torque" : " of force") + " pushes " + wayText(-p[0], seen.axis) +
           ", whichever way the axis moves: a tilted or loaded axis, a spring, or an offset of the current sensor or "
           "amplifier. Friction that "
           "differs between the two ways looks the same in a recording.";
  }
  std::vector<std::string_view> lookAlikes() const override {
    return {"coulomb_asymmetry", "viscous_asymmetry", "imbalance"};
  }
  std::string_view twin() const override { return "coulomb_asymmetry"; }
  std::string neededExcitation(const Excitation&) const override {
    return "Move both ways at the same speeds, and zero the current sensor with the drive off.";
  }
};

}  // namespace

const Effect& constantLoad() {
  static const ConstantLoad effect;
  return effect;
}

}  // namespace breakaway
