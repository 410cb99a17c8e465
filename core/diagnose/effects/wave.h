// The wave A·cos(kθ − φ) that position-dependent effects share: `order` per turn on a rotary axis (held, whole),
// `period_m` on a linear one (refined).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnose/model/effect.h"

namespace breakaway {

/// `amplitude` (a name with its unit), phase_rad, order or period_m.
std::vector<ParameterSpec> waveParameters(const std::string& amplitude, Axis axis);

/// What effects have in common that are a wave over the position.
class WaveEffect : public Effect {
 public:
  /// The amplitude is a torque or a force, unless overridden.
  std::vector<ParameterSpec> parameters(Axis axis) const override;
  /// Where the data can tell waves of several orders apart: on half a turn of a rotor.
  bool mayRepeat(const Excitation& seen) const override;
  /// Overtones and undertones over a travel: what repeats there is seldom one wave, and two of any periods can't be
  /// told from one another.
  std::vector<std::vector<double>> besides(std::span<const double> p, const Excitation& seen) const override;
  /// Parameters of a·cosine + b·sine: {A₀·hypot(a, b), atan2(b, a), k}.
  std::vector<double> scaled(const Shape& shape, std::span<const double> amplitude) const final;
  /// " With it, weaker: 14 times per turn (22 % of that)."
  Message furtherSentence(std::span<const double> largest, std::span<const std::vector<double>> further,
                          const Excitation& seen) const final;
  std::string_view drawnOver() const final { return "angle"; }
};

/// The mean of A·cos(kθ − φ) over the situation's span; `p` as waveParameters() has it.
double waveValue(std::span<const double> p, const Situation& at);
/// The same written down, with waveFunctions (written.h).
std::string waveWritten(Axis axis);
extern const char* const waveFunctions;
/// Cosine {A₀, 0, k} and sine {A₀, π/2, k} at the size A₀ = `amplitude`.
Shape waveBasis(double amplitude, double orderOrPeriod);
/// The same for what the travel and the encoder can show: orders from `lowest` to `highest` (rotary; a whole turn, or
/// two waves of it), or `lowest` to 50 waves over the travel (linear, where a screw's lead repeats often).
std::vector<Shape> waveShapes(const Excitation& seen, int lowest, int highest, double amplitude);
/// At most `largest` in amplitude, and not longer than the data shows: a longer wave is a spring or an offset.
bool wavePlausible(std::span<const double> p, const Excitation& seen, double largest, double longest = 1.5);

/// "12 times per turn", "every 5 mm".
Message waveText(double orderOrPeriod, Axis axis);
/// The angle within the turn, or the position above `lowest`, at which the wave peaks first.
std::string wavePeakText(std::span<const double> p, Axis axis, double lowest = 0.0);

}  // namespace breakaway
