// What an encoder that sits off its centre does to runs at constant speed.
#pragma once

#include <array>
#include <complex>
#include <optional>

#include "identify/friction_line.h"

namespace breakaway {

struct EncoderDisc;

/// A speed that an eccentric encoder (by e rad) shows as constant swings once per turn, and the rotor's inertia with
/// it: J·e·ω², one and the same wave on the shaft whichever way it turns, where friction grows with ω at most.
struct EncoderSwing {
  std::complex<double> wave;          ///< E, of ω², towards growing angle
  double variance = 0.0;              ///< of its real and imaginary part each
  std::array<FrictionLine, 2> lines;  ///< each way's, E's doubt in it; without residuals
  /// A gain in χ² of 20 for its two numbers.
  bool clear() const;
};

/// Fits that wave E beside each way's C + B·|ω| at order 1. Nothing where a way has fewer than three speeds.
std::optional<EncoderSwing> swingOf(const std::array<WayRuns, 2>& ways);

/// Takes the wave off the runs where it is clear, or `certain` is set; the doubt about it is in swingOf()'s lines, and
/// in no run's variance. Returns whether it was taken off.
bool takeOffEncoderSwing(std::array<WayRuns, 2>& ways, bool certain = false);

/// A run's torque is what is left of waves that can be a thousand times larger, the acceleration's and the disc's, and
/// what is off about them goes with them. Adds ρ²·w² to the variance at the orders 1 to 3, w being the larger of both
/// and ρ one number per order, by which what C + B·|ω| each way, E·ω² and an inertia that is off leave of all runs is
/// no more than chance (Paule and Mandel, "Consensus values and weighting factors", J. Res. NBS 87, 1982).
void widenBySwing(std::array<WayRuns, 2>& ways, double inertia_kg_m2, const EncoderDisc& disc);

}  // namespace breakaway
