// The wave A·cos(kθ − φ) that position-dependent effects share: `order` per turn on a rotary axis, `period_m` on a
// linear one.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnose/effect.h"

namespace breakaway {

/// amplitude (Nm or N), phase_rad, order or period_m (held).
std::vector<ParameterSpec> waveParameters(Axis axis);
/// A·cos(kθ − φ); `p` as waveParameters() has it.
double waveValue(std::span<const double> p, const Situation& at);
/// cos kθ and sin kθ, times `factor`.
void waveColumns(const Shape& shape, const Situation& at, double factor, std::span<double> out);
/// Parameters from the amplitudes of cosine and sine.
std::vector<double> waveFromAmplitudes(const Shape& shape, std::span<const double> amplitude);
/// Orders from `lowest` to `highest` (rotary) or periods (linear) that the travel (a whole turn, or two waves)
/// and the encoder can show.
std::vector<Shape> waveShapes(const Excitation& seen, int lowest, int highest);

/// "12 times per turn", "every 5 mm".
std::string waveText(double orderOrPeriod, Axis axis);
/// The angle or position at which the wave peaks first.
std::string wavePeakText(std::span<const double> p, Axis axis);

}  // namespace breakaway
