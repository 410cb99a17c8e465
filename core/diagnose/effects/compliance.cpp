#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "diagnose/effects/all.h"
#include "diagnose/effects/two_mass.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double typicalFriction = 0.25, mostFriction = 1.2;  // of the whole, which a base model knows badly

/// A coupling, belt or shaft that gives: part of the inertia swings behind a spring.
class Compliance final : public TwoMassEffect {
 public:
  std::string_view name() const override { return "compliance"; }
  std::string_view formula() const override {
    return "load = J_load (ω_a² δ + 2 ζ ω_a δ'),  J_load ω_load' = load − F_load sgn ω_load,  "
           "J_load taken from J, F_load from F";
  }
  std::string_view source() const override {
    return "G. Ellis, R. D. Lorenz, 'Resonant load control methods for industrial servo drives', IEEE Industry "
           "Applications Conference 2000: motor, spring and load with their antiresonance";
  }
  std::vector<ParameterSpec> parameters(Axis axis) const override {
    return {{inertiaName("load", axis), 1e-15, 1e9},
            {"antiresonance_rad_per_s", 0.1, highestFrequency},
            {"damping_ratio", 1e-4, 2.0},
            {.name = torqueName("load_friction", axis), .lower = 0.0, .upper = 1e9, .absentAtZero = true}};
  }
  std::vector<Shape> shapes(const Excitation& seen) const override {
    std::vector<Shape> shapes;
    if (seen.inertia <= 0.0 || seen.step_s <= 0.0) return shapes;
    for (double frequency = 5.0; frequency < 0.3 / seen.step_s; frequency *= 1.4)
      shapes.push_back({{0.3 * seen.inertia, frequency, 0.05, 0.0}});
    return shapes;
  }
  /// A heavier load with friction that is larger in proportion: it moves the same.
  std::vector<double> scaled(const Shape& shape, std::span<const double> amplitude) const override {
    const std::vector<double>& p = shape.front();
    return {p[0] * amplitude[0], p[1], p[2], p[3] * amplitude[0]};
  }
  /// Part of the friction on the load's side.
  std::vector<std::vector<double>> variants(std::span<const double> p, const Excitation& seen) const override {
    if (p[3] > 0.0 || seen.coulomb <= 0.0) return {};
    return {{p[0], p[1], p[2], typicalFriction * seen.coulomb}};
  }
  bool plausible(std::span<const double> p, const Excitation& seen) const override {
    if (seen.coulomb > 0.0 && p[3] > mostFriction * seen.coulomb) return false;
    return plausibleLoad(p[0], seen) && p[1] * seen.step_s < 1.5 && p[1] * seen.duration_s > 6.0;
  }
  std::string sentence(std::span<const double> p, const Excitation& seen) const override {
    const double motor = std::max(seen.inertia - p[0], 0.05 * seen.inertia);
    return "A load of " + inertiaText(p[0], seen.axis) + " (" + percentText(p[0] / seen.inertia) +
           " of the inertia) hangs on a spring: the motor hardly moves at " + hertzText(p[1]) + " and rings at " +
           hertzText(p[1] * std::sqrt(seen.inertia / motor)) +
           (p[3] > 0.0 ? "; " + torqueText(p[3], seen.axis) + " of the friction is on the load's side" : "") +
           ". Look at the coupling, the belt or a long shaft, and for a loose clamp.";
  }
  std::vector<std::string_view> lookAlikes() const override { return {"backlash", "transport_delay", "presliding"}; }
  std::vector<Tell> tells() const override { return {{"transport_delay", "rings at one frequency"}}; }
  std::string neededExcitation(const Excitation& seen) const override {
    const double highest = seen.step_s > 0.0 ? 1.0 / seen.step_s : 1e3;
    return "Chirp the command with ±" + digitsText(0.3 * seen.peakInput) + " from " + hertzText(5.0) + " to " +
           hertzText(highest) + " within 20 s.";
  }
  Maneuver neededManeuver(const Excitation& seen) const override {
    return seen.peakCurrent > 0.0 ? currentChirp(0.3 * seen.peakCurrent, 5.0, 100.0, 20.0) : Maneuver{};
  }
  std::string_view drawnOver() const override { return "frequency"; }

 private:
  std::string loadWritten() const override { return "clamp(p1, 0.001, 5000), p2, 0, p3 / p0"; }
  TwoMass loadOf(std::span<const double> p) const override {
    return {p[0], std::clamp(p[1], 1e-3, highestFrequency), p[2], 0.0, p[3]};
  }
  static std::string hertzText(double frequency_rad_per_s) {
    return digitsText(frequency_rad_per_s / turn_rad) + " Hz";
  }
};

}  // namespace

const Effect& compliance() {
  static const Compliance effect;
  return effect;
}

}  // namespace breakaway
