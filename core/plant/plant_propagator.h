// The exact solution of the motor's linear equations over a stretch of time in which voltage and dry torque are
// constant.
#pragma once

namespace breakaway {

/// L·di/dt = v − R·i − Ke·ω,  J·dω/dt = Kt·i − B·ω + τ.
struct LinearMotor {
  double torqueConstant = 0.0, backEmfConstant = 0.0, resistance_ohm = 0.0, inductance_H = 0.0, inertia = 0.0,
         viscous = 0.0;
};

/// (i, ω) after t is Φ·(i, ω) + Γ·(v/L, τ/J); from the matrix exponential in closed form.
struct Propagator {
  double phi[2][2];    ///< Φ = e^{A t}
  double gamma[2][2];  ///< Γ = ∫₀ᵗ e^{A s} ds
};

/// The windings closed: both equations.
Propagator closedWindings(const LinearMotor& motor, double duration_s);
/// The windings open: no current, the shaft alone.
Propagator openWindings(const LinearMotor& motor, double duration_s);

}  // namespace breakaway
