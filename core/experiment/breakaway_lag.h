// How long a rotor has been moving before its encoder shows it.
#pragma once

#include <vector>

namespace breakaway {

struct BreakawayLag {
  double inertia_kg_m2 = 0.0;
  double torqueConstant_Nm_per_A = 0.0;
  double backEmfConstant_V_s_per_rad = 0.0;  ///< 0: no braking by the winding
  double resistance_ohm = 0.0;
  double friction_A = 0.0;     ///< that it broke loose at, a part of which may fall with speed; 0: friction stays
  double windingTime_s = 0.0;  ///< L/R, by which the current follows a step of the voltage; 0: at once
};

/// Time in s from letting go until the travel reaches `travel_rad`, while the current's ramp goes on at `rate_A_per_s`.
/// From J·dω/dt = Kt·(r·t − Ke·ω/R): θ(t) = a·(t²/2 − T·t + T²·(1 − e^(−t/T)))·T with a = Kt·r/J and T = J·R/(Kt·Ke);
/// without back-EMF a·t³/6. Friction that falls with speed is left out: it is still flat where counts are fine. 0 when
/// the inertia is unknown.
double motionLag_s(const BreakawayLag& motor, double rate_A_per_s, double travel_rad);

/// The mean of motionLag_s up to the first count of `count_rad` over all places within a count at which the rotor may
/// have stood, weighted by how well each explains when the further counts followed: `edges_s` holds the times of the
/// first, second … count, read every `tick_s`. Where the rotor stands is no matter of chance: a position loop leaves it
/// just behind the edge at which its error vanished. The place is drawn from a uniform prior; one edge leaves that.
/// Where counts are coarse, friction has fallen by a good part before the first of them comes, and the rotor was
/// faster: falls S·d·(1 − e^(−(ω/ω_s)²)) of several sizes d over several speeds are as many further explanations of the
/// edges.
double likelyMotionLag_s(const BreakawayLag& motor, double rate_A_per_s, double count_rad,
                         const std::vector<double>& edges_s, double tick_s);

}  // namespace breakaway
