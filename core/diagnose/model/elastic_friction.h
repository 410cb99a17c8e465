// The part of effects that make friction give like a spring before it slides.
#pragma once

#include <cmath>
#include <span>

namespace breakaway {

/// The simulation builds the whole friction up over a reversal, as Dahl's model does.
class ElasticFriction {
 public:
  /// With which friction builds up, Nm/rad.
  virtual double stiffness(std::span<const double> p) const = 0;
  /// Damping while it builds up, as a part of what would be critical for the whole inertia on that stiffness.
  virtual double dampingRatio(std::span<const double> p) const = 0;

 protected:
  ~ElasticFriction() = default;
};

/// Elastic friction as a part of the full one, −1 … 1, after a further motion in rad (P. R. Dahl, 'Solid friction
/// damping of mechanical vibrations', AIAA Journal 14(12), 1976); `friction` is the full one, Nm.
inline double slipAfter(double slip, double motion, double stiffness, double friction) {
  if (motion == 0.0 || friction <= 0.0) return slip;
  const double s = motion > 0.0 ? 1.0 : -1.0;
  return s - (s - slip) * std::exp(-std::abs(motion) * stiffness / friction);
}

}  // namespace breakaway
