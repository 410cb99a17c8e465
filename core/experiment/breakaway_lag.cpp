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

namespace {

/// Friction falls by `drop_A` over a speed.
struct Fall {
  double drop_A = 0.0, speed_rad_per_s = 0.0;
};

/// None, and some sizes over some speeds; these as parts of the one at which the first count would be left behind.
std::vector<Fall> fallsOf(const BreakawayLag& motor, double rate_A_per_s, double count_rad) {
  std::vector<Fall> falls(3);  // no less likely than a fall of any one size
  const double count_s = motionLag_s(motor, rate_A_per_s, count_rad);
  if (!(motor.friction_A > 0.0) || !(count_s > 0.0)) return falls;
  for (const double size : {0.07, 0.15, 0.3, 0.5}) {
    for (const double part : {0.3, 1.0, 3.0})
      falls.push_back({size * motor.friction_A, part * 3.0 * count_rad / count_s});
  }
  return falls;
}

/// When a rotor has come how far since it let go.
class Motion {
 public:
  Motion(const BreakawayLag& motor, double rate_A_per_s, const Fall& fall, double most_rad) {
    constexpr int steps = 300;
    const double step_s = motionLag_s(motor, rate_A_per_s, most_rad) / steps;
    const double Kt = motor.torqueConstant_Nm_per_A, J = motor.inertia_kg_m2;
    const double braking =
        motor.resistance_ohm > 0.0 ? Kt * motor.backEmfConstant_V_s_per_rad / motor.resistance_ohm : 0.0;
    const auto accelerated = [&](double time_s, double speed) {
      const double x = fall.speed_rad_per_s > 0.0 ? speed / fall.speed_rad_per_s : 0.0;
      const double driven_A = rate_A_per_s * time_s - fall.drop_A * std::expm1(-x * x);
      return (Kt * driven_A - braking * speed) / J;
    };
    double speed = 0.0, angle = 0.0;
    for (int k = 0; k <= steps && angle < most_rad; ++k) {
      const double now_s = k * step_s, middle = speed + 0.5 * step_s * accelerated(now_s, speed);
      speed += step_s * accelerated(now_s + 0.5 * step_s, middle);
      angle += step_s * middle;
      times_s_.push_back(now_s + step_s);
      angles_rad_.push_back(angle);
    }
  }
  double timeTo(double travel_rad) const {
    const auto after = std::lower_bound(angles_rad_.begin(), angles_rad_.end(), travel_rad);
    const auto k = static_cast<size_t>(after - angles_rad_.begin());
    if (k >= times_s_.size()) return times_s_.back();
    // Early on the travel grows with the cube of the time.
    const double from_s = k > 0 ? times_s_[k - 1] : 0.0, from_rad = k > 0 ? angles_rad_[k - 1] : 0.0;
    const double part =
        k > 0 ? (travel_rad - from_rad) / (angles_rad_[k] - from_rad) : std::cbrt(travel_rad / angles_rad_[0]);
    return from_s + part * (times_s_[k] - from_s);
  }

 private:
  std::vector<double> times_s_, angles_rad_;
};

}  // namespace

double likelyMotionLag_s(const BreakawayLag& motor, double rate_A_per_s, double count_rad,
                         const std::vector<double>& edges_s, double tick_s) {
  constexpr int places = 20;
  constexpr double modelDoubt = 0.03;  // of a time: inertia, torque constant, friction's gradient
  if (!(motionLag_s(motor, rate_A_per_s, count_rad) > 0.0)) return 0.0;
  std::vector<double> lags_s, squares;
  for (const Fall& fall : fallsOf(motor, rate_A_per_s, count_rad)) {
    const Motion motion(motor, rate_A_per_s, fall,
                        static_cast<double>(std::max<size_t>(1, edges_s.size())) * count_rad);
    for (int place = 0; place < places; ++place) {
      const double toEdge = (place + 0.5) / places, first_s = motion.timeTo(toEdge * count_rad);
      double sum = 0.0;
      for (size_t k = 1; k < edges_s.size(); ++k) {
        const double lag_s = motion.timeTo((toEdge + static_cast<double>(k)) * count_rad);
        const double off_s = (edges_s[k] - edges_s[0]) - (lag_s - first_s), doubt_s = modelDoubt * lag_s;
        sum += off_s * off_s / (tick_s * tick_s / 6.0 + doubt_s * doubt_s + 1e-18);
      }
      lags_s.push_back(first_s);
      squares.push_back(sum);
    }
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
