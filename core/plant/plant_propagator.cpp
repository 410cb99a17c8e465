#include "plant/plant_propagator.h"

#include <cmath>

namespace breakaway {

namespace {

/// sinh(x·t)/x for x² = square, real or imaginary x, continuous through zero.
double sinhOver(double square, double t) {
  const double z = square * t * t;
  if (std::abs(z) < 1e-6) return t * (1.0 + z / 6.0 * (1.0 + z / 20.0));
  const double x = std::sqrt(std::abs(square));
  return square > 0.0 ? std::sinh(x * t) / x : std::sin(x * t) / x;
}

double coshOf(double square, double t) {
  const double x = std::sqrt(std::abs(square));
  return square > 0.0 ? std::cosh(x * t) : std::cos(x * t);
}

}  // namespace

Propagator closedWindings(const LinearMotor& m, double t) {
  const double a = -m.resistance_ohm / m.inductance_H, b = -m.backEmfConstant / m.inductance_H;
  const double c = m.torqueConstant / m.inertia, d = -m.viscous / m.inertia;
  // e^{At} = e^{μt}·(cosh(δt)·I + sinh(δt)/δ·(A − μI)), μ half the trace, δ² = μ² − det A.
  const double mu = 0.5 * (a + d), determinant = a * d - b * c;
  const double square = mu * mu - determinant;
  const double grown = std::exp(mu * t), ch = grown * coshOf(square, t), sh = grown * sinhOver(square, t);
  Propagator p;
  p.phi[0][0] = ch + sh * (a - mu);
  p.phi[0][1] = sh * b;
  p.phi[1][0] = sh * c;
  p.phi[1][1] = ch + sh * (d - mu);
  // Γ = A⁻¹·(Φ − I); the determinant is (R·B + Kt·Ke)/(L·J), above zero for any motor.
  const double e00 = p.phi[0][0] - 1.0, e11 = p.phi[1][1] - 1.0;
  p.gamma[0][0] = (d * e00 - b * p.phi[1][0]) / determinant;
  p.gamma[0][1] = (d * p.phi[0][1] - b * e11) / determinant;
  p.gamma[1][0] = (a * p.phi[1][0] - c * e00) / determinant;
  p.gamma[1][1] = (a * e11 - c * p.phi[0][1]) / determinant;
  return p;
}

Propagator openWindings(const LinearMotor& m, double t) {
  const double rate = m.viscous / m.inertia;
  const double fall = -std::expm1(-rate * t);
  Propagator p{};
  p.phi[1][1] = 1.0 - fall;
  p.gamma[1][1] = rate > 0.0 ? fall / rate : t;
  return p;
}

}  // namespace breakaway
