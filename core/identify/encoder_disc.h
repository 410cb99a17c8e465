// An encoder's disc that sits off its shaft's centre.
#pragma once

#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "friction/measurements.h"

namespace breakaway {

struct VelocityFrictionOptions;

/// Shows a rotor that stands at θ at θ + Re(D·e^{jθ}) − Re(D), both from the index.
struct EncoderDisc {
  std::complex<double> off_rad;  ///< D
  double variance_rad2 = 0.0;    ///< of D's real and imaginary part each
  double unsettled_rad = 0.0;    ///< |D| as last seen, where such a wave shows clearly and yet no D explains it

  bool known() const { return off_rad != 0.0; }
  /// Standard error of angles from the index, on average around the turn.
  double angleError_rad() const { return std::sqrt(2.0 * variance_rad2); }
  double angleOf(double shown_rad) const;
  /// dθ/dshown at the rotor's angle.
  double gainAt(double angle_rad) const;
  /// The rotor's speed around this angle, both as central differences over ± this time: over a span the disc's swing is
  /// flatter than at an instant.
  double speedOf(double shown_rad_per_s, double angle_rad, double halfSpan_s) const;
};

/// A speed that is shown as constant swings once per turn, and the rotor's inertia with it, by J·D·ω² whichever way it
/// turns (encoder_swing.h): D from that wave in runs at constant speed, by going on from what the last D leaves of it.
/// None where the wave doesn't clearly show, where it doesn't settle or is larger than any disc (unsettled_rad), and
/// where a way has fewer than three speeds.
EncoderDisc fitDisc(const std::vector<VelocityRun>& runs, const VelocityFrictionOptions& options);

/// The breakaways at the angles where the rotor really stood.
void placeBy(const EncoderDisc& disc, std::span<BreakawayEvent> events);

}  // namespace breakaway
