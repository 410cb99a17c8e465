#include "experiment/breakaway_lag.h"

#include <algorithm>
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

double likelyMotionLag_s(const BreakawayLag& motor, double rate_A_per_s, double count_rad,
                         const std::vector<double>& edges_s, double tick_s) {
  constexpr int places = 20;
  constexpr double modelDoubt = 0.03;  // of a time: inertia, torque constant, friction's gradient
  std::vector<double> lags_s, squares;
  for (int place = 0; place < places; ++place) {
    const double toEdge = (place + 0.5) / places;
    const double first_s = motionLag_s(motor, rate_A_per_s, toEdge * count_rad);
    double sum = 0.0;
    for (size_t k = 1; k < edges_s.size(); ++k) {
      const double lag_s = motionLag_s(motor, rate_A_per_s, (toEdge + static_cast<double>(k)) * count_rad);
      const double off_s = (edges_s[k] - edges_s[0]) - (lag_s - first_s), doubt_s = modelDoubt * lag_s;
      sum += off_s * off_s / (tick_s * tick_s / 6.0 + doubt_s * doubt_s + 1e-18);
    }
    lags_s.push_back(first_s);
    squares.push_back(sum);
  }
  const double least = *std::min_element(squares.begin(), squares.end());
  double weights = 0.0, sum_s = 0.0;
  for (size_t k = 0; k < lags_s.size(); ++k) {
    const double weight = std::exp(-0.5 * (squares[k] - least));
    weights += weight;
    sum_s += weight * lags_s[k];
  }
  return sum_s / weights;
}

}  // namespace breakaway
