// The part of effects that make friction give like a spring before it slides.
#pragma once

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

}  // namespace breakaway
