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
  Message sentence(std::span<const double> p, const Excitation& seen) const override {
    const double motor = std::max(seen.inertia - p[0], 0.05 * seen.inertia);
    const Message friction =
        p[3] > 0.0 ? message("; {} of the friction is on the load's side", torqueText(p[3], seen.axis)) : Message();
    return message(
        "A load of {} ({} of the inertia) hangs on a spring: the motor hardly moves at {} and rings at {}{}. Look at "
        "the coupling, the belt or a long shaft, and for a loose clamp.",
        inertiaText(p[0], seen.axis), percentText(p[0] / seen.inertia), hertzText(p[1]),
        hertzText(p[1] * std::sqrt(seen.inertia / motor)), friction);
  }
  std::vector<std::string_view> lookAlikes() const override { return {"backlash", "transport_delay", "presliding"}; }
  std::vector<Tell> tells() const override { return {{"transport_delay", message("rings at one frequency")}}; }
  Message neededExcitation(const Excitation& seen) const override {
    const double highest = seen.step_s > 0.0 ? 1.0 / seen.step_s : 1e3;
    return message("Chirp the command with ±{} from {} to {} within 20 s.", digitsText(0.3 * seen.peakInput),
                   hertzText(5.0), hertzText(highest));
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
