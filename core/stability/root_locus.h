// Where the poles go when the observer's cutoff grows, and how far it may.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "stability/servo_loop.h"

namespace breakaway {

/// The closed loop's poles over the observer's cutoff. `branches[b][k]` is branch b at `cutoff_rad_per_s[k]`; branches
/// are joined so that the poles of neighbouring cutoffs are nearest.
struct RootLocus {
  std::vector<double> cutoff_rad_per_s;
  std::vector<std::vector<std::complex<double>>> branches;
};

/// Poles in the z plane at each cutoff in rad/s, all of them positive; everything else as in `loop`. Precondition:
/// check(loop).
RootLocus rootLocus(const ServoLoop& loop, const std::vector<double>& cutoffs_rad_per_s);

/// `count` values from `low` to `high`, evenly spaced on a logarithmic scale. Precondition: 0 < low < high, count ≥ 2.
std::vector<double> decades(double low, double high, size_t count);

/// The loop with another cutoff.
ServoLoop withCutoff(ServoLoop loop, double cutoff_rad_per_s);

/// How far the cutoff may go. Exact answers are the first crossing met from below, searched up to `searched_rad_per_s`;
/// empty: none is met (the loop is stable, or damped, throughout) or the loop is bad at the lowest cutoff already.
struct CutoffBounds {
  double searched_rad_per_s = 0.0;             ///< 10/T, where the observer follows within a tick
  bool stableBelow = false;                    ///< stable at the lowest cutoff
  bool dampedBelow = false;                    ///< ζ ≥ 0.707 at the lowest cutoff
  std::optional<double> unstable_rad_per_s;    ///< from here on a pole is outside the unit circle
  std::optional<double> lessDamped_rad_per_s;  ///< from here on damping() is below 0.707
  double ruleOfThumb_rad_per_s = 0.0;          ///< α·g·T = 0.3
  std::optional<double> filterRule_rad_per_s;  ///< αg = g_v/2, ζ = ½√(g_v/(αg)) behind a speed observer of g_v
};

/// The bounds on the cutoff for this loop; its own cutoff doesn't matter. Precondition: check(loop).
CutoffBounds cutoffBounds(const ServoLoop& loop);

}  // namespace breakaway
