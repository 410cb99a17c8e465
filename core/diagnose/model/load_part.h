// The part of effects that bring a load along which has a motion of its own.
#pragma once

#include <span>

#include "base/numbers.h"
#include "diagnose/model/hidden_state.h"

namespace breakaway {

/// A load behind a spring with damping and, maybe, a gap. Inertia and friction are taken from the motor's side.
struct TwoMass {
  double inertia = 0.0;       ///< J_load, kg m²
  double frequency = 0.0;     ///< ω_a = √(k/J_load), the antiresonance, rad/s; positive
  double dampingRatio = 0.0;  ///< ζ
  double halfGap = 0.0;       ///< rad
  double friction = 0.0;      ///< F_load, Nm: Coulomb's, on the load's side; only where there is no gap

  double stiffness() const { return inertia * frequency * frequency; }
  /// With which the load swings against a motor that is held, s.
  double period_s() const { return turn_rad / frequency; }
  /// Between motor and load, rad.
  double play() const { return 2.0 * halfGap; }
};

/// The first two numbers of hidden state are the load's place and speed relative to the motor, rad and rad/s: a restart
/// finds them from the measured motion.
class LoadPart : public HiddenState {
 public:
  virtual TwoMass loadOf(std::span<const double> p) const = 0;
  /// Sets the hidden state for a load at this place and speed relative to a motor that moves at `velocity`.
  virtual void place(double place, double speed, double velocity, double time_s, std::span<double> memory) const = 0;

 protected:
  ~LoadPart() = default;
};

}  // namespace breakaway
