// What an encoder that sits off its centre does to runs at constant speed.
#pragma once

#include <array>
#include <complex>
#include <optional>

#include "identify/friction_line.h"

namespace breakaway {

/// A speed that an eccentric encoder (by e rad) shows as constant swings once per turn, and the rotor's inertia with
/// it: J·e·ω², one and the same wave on the shaft whichever way it turns, where friction grows with ω at most.
struct EncoderSwing {
  std::complex<double> wave;  ///< E, of ω², towards growing angle
  double variance = 0.0;      ///< of its real and imaginary part each
  /// A gain in χ² of 20 for its two numbers.
  bool clear() const;
};

/// Fits that wave E beside each way's C + B·|ω| at order 1. Nothing where a way has fewer than three speeds.
std::optional<EncoderSwing> swingOf(const std::array<WayRuns, 2>& ways);

/// Takes the wave off the runs where it is clear, or `certain` is set; its doubt goes to their variance.
void takeOffEncoderSwing(std::array<WayRuns, 2>& ways, bool certain = false);

}  // namespace breakaway
