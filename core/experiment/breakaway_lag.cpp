#include "experiment/breakaway_lag.h"

#include <cmath>

namespace breakaway {

double motionLag_s(const BreakawayLag& motor, double rate_A_per_s, double travel_rad) {
  if (!(motor.inertia_kg_m2 > 0.0) || !(motor.torqueConstant_Nm_per_A > 0.0) || !(rate_A_per_s > 0.0) ||
      !(travel_rad > 0.0)) {
    return 0.0;
  }
  const double a = motor.torqueConstant_Nm_per_A * rate_A_per_s / motor.inertia_kg_m2;
  const double free_s = std::cbrt(6.0 * travel_rad / a);
  if (!(motor.backEmfConstant_V_s_per_rad > 0.0) || !(motor.resistance_ohm > 0.0)) return free_s;
  const double T =
      motor.inertia_kg_m2 * motor.resistance_ohm / (motor.torqueConstant_Nm_per_A * motor.backEmfConstant_V_s_per_rad);
  const auto travel = [a, T](double t) {
    const double x = t / T;
    if (x < 1e-3) return a * t * t * t / 6.0;
    return a * T * T * T * (0.5 * x * x - x - std::expm1(-x));
  };
  // Braking only lengthens the time, so the free time is a lower bound.
  double low = free_s, high = 2.0 * free_s + T;
  while (travel(high) < travel_rad) high *= 2.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (travel(middle) < travel_rad ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double meanMotionLag_s(const BreakawayLag& motor, double rate_A_per_s, double count_rad) {
  constexpr int places = 8;
  double sum_s = 0.0;
  for (int k = 0; k < places; ++k) sum_s += motionLag_s(motor, rate_A_per_s, (k + 0.5) / places * count_rad);
  return sum_s / places;
}

}  // namespace breakaway
