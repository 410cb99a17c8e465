#include "identify/wiring_fit.h"

#include <fmt/core.h>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dense/dense_solve.h"
#include "experiment/wiring_check.h"

namespace breakaway {

namespace {

constexpr double bent = 0.1;          // of the resistance: what the bridge's curve and the inductance hide
constexpr double unknownOnset = 0.2;  // likewise, of a level's distance to the next
constexpr double unequal = 0.3;       // of the breakaway current: less is its own scatter and position torque
constexpr double supplyPart = 0.06;   // of the supply, that readings differ by
constexpr double seen = 5.0;          // standard errors
constexpr size_t fewest = 8;          // moments of a kick
constexpr double stillRising = 0.02;  // of the current: what noise leaves unseen of its rise
constexpr double leastTold = 0.5;     // of the square of the angle's course that must not be the encoder's rounding

struct Course {
  Estimate standing_A;    ///< that would flow without motion
  Estimate perSpeed_A_s;  ///< Ke/R: what each rad/s takes off
};

/// Of the current about a moment, so that its noise doesn't stand beside it in the equations.
double smoothed(const std::vector<WiringCheck::Moment>& at, size_t k) {
  const size_t reach = std::min({k, at.size() - 1 - k, size_t{2}});
  double sum = 0.0;
  for (size_t j = k - reach; j <= k + reach; ++j) sum += at[j].current_A;
  return sum / static_cast<double>(2 * reach + 1);
}

/// Least squares of the integral, free of what an encoder's rounding adds to the square of the angle (it would take
/// the back-EMF for a smaller one; W. A. Fuller, Measurement Error Models, section 2.2). The errors are those that
/// white noise of the current makes, and as much of the slope as was the rounding's. None where that is most of it.
std::optional<Course> courseOf(const WiringCheck::Kick& kick, double noise_A, double count_rad) {
  const auto& at = kick.moments;
  if (at.size() < fewest || !kick.steady) return {};
  const auto n = static_cast<Eigen::Index>(at.size());
  Eigen::MatrixX3d rows(n, 3);
  Eigen::VectorXd charge_As = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto& now = at[static_cast<size_t>(k)];
    if (k > 0) {
      const auto& before = at[static_cast<size_t>(k - 1)];
      charge_As[k] = charge_As[k - 1] + 0.5 * (now.current_A + before.current_A) * (now.time_s - before.time_s);
    }
    rows.row(k) << now.time_s, -now.angle_rad, -1e-3 * smoothed(at, static_cast<size_t>(k));
  }
  Eigen::Matrix3d normal = rows.transpose() * rows;
  const double rounding_rad2 = static_cast<double>(n) * count_rad * count_rad / 6.0;  // with where in a count it began
  const double told = 1.0 - rounding_rad2 * pseudoInverse(normal)(1, 1);
  if (told < leastTold) return {};
  normal(1, 1) -= rounding_rad2;
  const Eigen::Matrix3Xd inverse = pseudoInverse(normal) * rows.transpose();
  const Eigen::Vector3d x = inverse * charge_As;
  const double tick_s = at.back().time_s / static_cast<double>(n - 1);
  Eigen::Vector3d later = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    later += inverse.col(k);
    squares += later.cwiseAbs2();
  }
  const double angle_rad = std::abs(at.back().angle_rad);
  const double fastest_rad_per_s = 2.0 * angle_rad / at.back().time_s;
  const Eigen::Vector3d error = noise_A * tick_s * squares.cwiseSqrt();
  const double rest = stillRising * std::abs(x[0]) / fastest_rad_per_s;
  const double rounded = x[1] * std::max(count_rad / angle_rad, 1.0 - told);
  return Course{{x[0], error[0]}, {x[1], std::hypot(error[1], rounded, rest)}};
}

/// The mean by weights, with the error of one that shares what the others have.
Estimate weighted(const std::vector<Estimate>& all) {
  double weights = 0.0, sum = 0.0;
  for (const Estimate& one : all) {
    const double weight = 1.0 / (one.standardError * one.standardError);
    weights += weight;
    sum += weight * one.value;
  }
  return weights > 0.0 ? Estimate{sum / weights, 1.0 / std::sqrt(weights)} : Estimate{};
}

/// From the highest level that the shaft stood at that way, to the kick's. Where no current was seen at that, the
/// bridge may begin to conduct a little above it.
std::optional<Estimate> resistanceOf(const WiringCheck::Kick& kick, const Course& course,
                                     const std::optional<WiringCheck::Level>& standing) {
  const WiringCheck::Level from = standing.value_or(WiringCheck::Level{});
  const double current_A = course.standing_A.value - from.current_A, voltage_V = kick.voltage_V - from.voltage_V;
  const double error_A = std::hypot(course.standing_A.standardError, from.error_A);
  if (!(std::abs(current_A) > seen * error_A) || current_A * voltage_V <= 0.0) return {};
  const bool conducts = std::abs(from.current_A) > seen * from.error_A;
  const double resistance = voltage_V / current_A;
  return Estimate{resistance, resistance * std::hypot(error_A / current_A, conducts ? bent : unknownOnset)};
}

std::string currentText(double current_A) {
  return std::abs(current_A) < 0.995 ? fmt::format("{:.0f} mA", 1e3 * current_A) : fmt::format("{:.2f} A", current_A);
}

Message shaftWords(const WiringFit& fit, Axis axis) {
  const Message body = axis == Axis::rotary ? message("Shaft") : message("Axis");
  const auto &down = fit.breakaway_A[0], &up = fit.breakaway_A[1];
  if (!down || !up)
    return message("{}: moves {} only; a stop, or a load, holds it the other way.", body,
                   wayText(up.has_value(), axis));
  if (fit.stopped[0] || fit.stopped[1])
    return message("{}: moves a little {} and is stopped there; a stop, or a hard spot.", body,
                   wayText(fit.stopped[1], axis));
  const Message ways = message("{}: breaks loose {} at {} and {} at {}", body, wayText(false, axis),
                               currentText(down->value), wayText(true, axis), currentText(up->value));
  const double mean = 0.5 * (down->value + up->value), load = 0.5 * (down->value - up->value);
  const double error = 0.5 * std::hypot(down->standardError, up->standardError);
  if (std::abs(load) < std::max(unequal * mean, seen * error)) return message("{}; no load is seen.", ways);
  return message("{}; a load of about {} (or position torque as large) acts {} here.", ways,
                 currentText(std::abs(load)), wayText(load > 0.0, axis));
}

Message sensorWords(const WiringFit& fit, const Estimate& zero_A, double noiseRms_A) {
  const Message rest =
      message("its zero was off by {}, its noise is {} rms.", currentText(zero_A.value), currentText(noiseRms_A));
  if (!fit.currentSeen) return message("Current sensor: sees nothing of so small a current; {}", rest);
  if (!(fit.resistance_ohm.standardError > 0.0)) return message("Current sensor: rises with the voltage; {}", rest);
  return message("Current sensor: rises with the voltage, by 1 A for {:.2g} V; {}", fit.resistance_ohm.value, rest);
}

}  // namespace

WiringFit fitWiring(const WiringCheck& check) {
  WiringFit fit;
  fit.breakaway_A = check.breakaway_A();
  fit.currentSeen = check.currentSeen();
  fit.supply_V = check.supply_V();
  std::array<bool, 2> fellShort{};
  for (const WiringCheck::Kick& kick : check.kicks()) fellShort[kick.voltage_V > 0.0 ? 1 : 0] |= !kick.far;
  for (size_t way = 0; way < 2; ++way) fit.stopped[way] = fellShort[way] && !fellShort[1 - way];
  const double noise_A = check.options().noise_A;
  std::vector<Estimate> resistances, slopes;
  for (const WiringCheck::Kick& kick : check.kicks()) {
    const auto course = courseOf(kick, noise_A, check.options().count_rad);
    if (!course) continue;
    slopes.push_back(course->perSpeed_A_s);
    if (const auto one = resistanceOf(kick, *course, check.standing()[kick.voltage_V > 0.0 ? 1 : 0]))
      resistances.push_back(*one);
  }
  if (resistances.empty()) return fit;
  fit.resistance_ohm = weighted(resistances);
  // The bridge's curve is shared by all kicks.
  fit.resistance_ohm.standardError = std::max(fit.resistance_ohm.standardError, bent * fit.resistance_ohm.value);
  if (slopes.empty()) return fit;
  const Estimate slope = weighted(slopes);
  const double R = fit.resistance_ohm.value, Ke = R * slope.value;
  if (!(slope.value > 0.0)) return fit;
  fit.backEmf_V_s_per_rad = {Ke, std::hypot(R * slope.standardError, slope.value * fit.resistance_ohm.standardError)};
  return fit;
}

std::vector<Message> inWords(const WiringFit& fit, const Estimate& zero_A, double noiseRms_A, double supply_V,
                             Axis axis) {
  std::vector<Message> words{message("Motor and encoder: count the same way."), sensorWords(fit, zero_A, noiseRms_A)};
  const bool right = std::abs(fit.supply_V / supply_V - 1.0) < supplyPart;
  words.push_back(right ? message("Supply: reads {:.1f} V, as the board declares.", fit.supply_V)
                        : message("Supply: reads {:.1f} V where {:.1f} V belong; measure it, and look at its divider.",
                                  fit.supply_V, supply_V));
  const Estimate& Ke = fit.backEmf_V_s_per_rad;
  words.push_back(Ke.standardError > 0.0
                      ? message("Counts: as the encoder counts, the back-EMF constant is {:.2g} {} (give or take "
                                "{:.1g}).",
                                Ke.value, axis == Axis::rotary ? "V s/rad" : "V s/m", 2.0 * Ke.standardError)
                      : message("Counts: so small a motion doesn't tell the back-EMF constant."));
  words.push_back(shaftWords(fit, axis));
  return words;
}

}  // namespace breakaway
