// How long a rotor has been moving before its encoder shows it.
#pragma once

namespace breakaway {

struct BreakawayLag {
  double inertia_kg_m2 = 0.0;
  double torqueConstant_Nm_per_A = 0.0;
  double backEmfConstant_V_s_per_rad = 0.0;  ///< 0: no braking by the winding
  double resistance_ohm = 0.0;
};

/// Time in s from letting go until the travel reaches `travel_rad`, while the current's ramp goes on at `rate_A_per_s`.
/// From J·dω/dt = Kt·(r·t − Ke·ω/R): θ(t) = a·(t²/2 − T·t + T²·(1 − e^(−t/T)))·T with a = Kt·r/J and T = J·R/(Kt·Ke);
/// without back-EMF a·t³/6. Friction that falls with speed is left out: it is still flat at such speeds. 0 when the
/// inertia is unknown.
double motionLag_s(const BreakawayLag& motor, double rate_A_per_s, double travel_rad);

/// The mean of motionLag_s for a rotor that stands anywhere within a count of `count_rad`, each place as likely.
double meanMotionLag_s(const BreakawayLag& motor, double rate_A_per_s, double count_rad);

}  // namespace breakaway
