// The wave A·cos(kθ − φ) that position-dependent effects share: `order` per turn on a rotary axis (held, whole),
// `period_m` on a linear one (refined).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnose/model/effect.h"
#include "diagnose/model/model.h"

namespace breakaway {

/// `amplitude` (a name with its unit; without one amplitude_Nm or amplitude_N), phase_rad, order or period_m.
std::vector<ParameterSpec> waveParameters(const std::string& amplitude, Axis axis);
std::vector<ParameterSpec> waveParameters(Axis axis);
/// The mean of A·cos(kθ − φ) over the situation's span; `p` as waveParameters() has it.
double waveValue(std::span<const double> p, const Situation& at);
/// Cosine {A₀, 0, k} and sine {A₀, π/2, k} at the size A₀ = `amplitude`, for what the travel and the encoder can show:
/// orders from `lowest` to `highest` (rotary; a whole turn, or two waves of it), or `lowest` to 50 waves over the
/// travel (linear, where a screw's lead repeats often).
std::vector<Shape> waveShapes(const Excitation& seen, int lowest, int highest, double amplitude);
/// Parameters of a·cosine + b·sine: {A₀·hypot(a, b), atan2(b, a), k}.
std::vector<double> waveScaled(const Shape& shape, std::span<const double> amplitude);
/// At most `largest` in amplitude, and not longer than the data shows: a longer wave is a spring or an offset.
bool wavePlausible(std::span<const double> p, const Excitation& seen, double largest, double longest = 1.5);

/// Whether the data can tell waves of several orders apart: half a turn of a rotor.
bool wavesAreTold(const Excitation& seen);

/// "12 times per turn", "every 5 mm".
std::string waveText(double orderOrPeriod, Axis axis);
/// The angle within the turn, or the position above `lowest`, at which the wave peaks first.
std::string wavePeakText(std::span<const double> p, Axis axis, double lowest = 0.0);

/// Of an effect's terms, what those after the first add to its sentence: " With it, weaker: 14 times per turn (22 %)."
/// Empty for one term.
std::string furtherWavesText(const std::vector<EffectTerm>& terms);

}  // namespace breakaway
