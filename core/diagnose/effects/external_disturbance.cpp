#include <algorithm>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

/// A torque from outside during a window in time, positive towards growing position. The window's edges are ramps of
/// 2 % of its duration, so that a fit feels where they are.
class ExternalDisturbance final : public Effect {
 public:
  std::string_view name() const override { return "external_disturbance"; }
  std::string_view formula() const override { return "load = −τ while t₀ ≤ t < t₀ + T"; }
  std::string_view source() const override {
    return "K. Ohnishi, M. Shibata, T. Murakami, 'Motion control for advanced mechatronics', IEEE/ASME Trans. "
           "Mechatronics 1(1), 1996: the external part of the disturbance torque";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{torqueName(axis == Axis::rotary ? "torque" : "force", axis), -1e9, 1e9},
            {"start_s", -1e9, 1e9},
            {"duration_s", 1e-3, 1e9}};
  }
  Term term(std::span<const double> p, const Situation& at) const override {
    const double fromEdge = 0.5 * p[2] - std::abs(at.time_s - p[1] - 0.5 * p[2]);  // s, positive inside
    return {.load_Nm = -p[0] * std::clamp(0.5 + fromEdge / (0.02 * p[2]), 0.0, 1.0)};
  }
  Written written(std::span<const double>, Axis) const override {
    return {.lacking = "it happened once, in one recording"};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.peakTorque <= 0.0) return shapes;
    // Starts half a duration apart and durations twice as long each time: 4 · length/shortest shapes, at most 150.
    for (double length = std::max(0.25, seen.duration_s / 37.0); length < 0.4 * seen.duration_s; length *= 2.0) {
      for (double start = 0.0; start + 0.5 * length < seen.duration_s; start += 0.5 * length)
        shapes.push_back({{0.1 * seen.peakTorque, start, length}});
    }
    return shapes;
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    return std::abs(p[0]) < 3.0 * seen.peakTorque && p[2] < 0.8 * seen.duration_s && p[1] < seen.duration_s &&
           p[1] + p[2] > 0.0;
  }
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    return message(
        "From {} to {} after the recording's begin something pushed {} with {}: a hand, a cable, a load put on. Look "
        "at what happened then, and repeat the recording without it.",
        timeText(p[1]), timeText(p[1] + p[2]), wayText(p[0], seen.axis), torqueText(std::abs(p[0]), seen.axis));
  }
  std::vector<std::string_view> lookAlikes() const override { return {"constant_load", "friction_warmup"}; }
  std::vector<Tell> tells() const override { return {{"friction_warmup", message("doesn't come again")}}; }
  Message neededExcitation(const Excitation& seen) const override {
    return message(
        "Repeat the same motion of {} untouched: what came from outside doesn't come again at the same time.",
        timeText(seen.duration_s));
  }
  const OncePart* once() const override {
    static constexpr OncePart when{.start = 1, .duration = 2};
    return &when;
  }
  bool mayRepeat(const Excitation&) const override { return true; }  // each at a time of its own
  std::string_view drawnOver() const override { return "time"; }
};

}  // namespace

const Effect& externalDisturbance() {
  static const ExternalDisturbance effect;
  return effect;
}

}  // namespace breakaway
