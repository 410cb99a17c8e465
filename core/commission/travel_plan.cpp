#include "commission/travel_plan.h"

#include <algorithm>
#include <cmath>

#include "commission/careful_tuning.h"

namespace breakaway {

namespace {

/// Long enough to bring the zero's noise to 0.3 % of the friction's current, within reason.
double zeroing_s(const KnownAxis& axis) {
  const double friction_A = std::max(1e-6, axis.motor.coulomb_Nm.value / axis.forcePerAmpere());
  const double aim_A = 0.003 * friction_A;
  return std::clamp(axis.noiseRms_A * axis.noiseRms_A / (aim_A * aim_A) / axis.board.loopRate_Hz, 0.4, 4.0);
}

}  // namespace

Travel moved(const Travel& travel, double by_m) {
  return {travel.low_m + by_m, travel.high_m + by_m, travel.margin_m};
}

bool sameEnds(const Travel& before, const Travel& now) {
  constexpr double part = 0.01;
  const double most_m = part * (before.high_m - before.low_m);
  return std::abs(before.low_m - now.low_m) <= most_m && std::abs(before.high_m - now.high_m) <= most_m;
}

TravelPace paceOf(const KnownAxis& axis) {
  const IdentifiedMotor& motor = axis.motor;
  const double friction_A = std::max(0.01, motor.coulomb_Nm.value / motor.torqueConstant_Nm_per_A.value);
  const double spare_A = std::max(0.2 * friction_A, 0.5 * (axis.current_limit_A - friction_A));
  TravelPace pace;
  pace.acceleration_m_per_s2 = axis.forcePerAmpere() * std::min(1.5 * friction_A, spare_A) / motor.inertia_kg_m2.value;
  const double supply_V = axis.board.supply_V;
  const double usable_V = supply_V - motor.deadZone_V.value - 3.0 * axis.shownResistance_ohm * friction_A;
  const double byTravel = std::sqrt(2.0 * pace.acceleration_m_per_s2 * 0.3 * axis.travel.usable_m());
  pace.speed_m_per_s =
      std::min(byTravel, std::max(0.05 * supply_V, 0.7 * usable_V) / motor.backEmfConstant_V_s_per_rad.value);
  return pace;
}

ControllerSettings carefulSettings(const KnownAxis& axis, const TravelPace& pace, const ControllerSettings& present) {
  ControllerSettings settings =
      carefullyTuned(axis.motor.inertia_kg_m2.value, axis.forcePerAmpere(), 1.0 / axis.board.loopRate_Hz, present);
  settings.velocity_limit_rad_per_s = 0.3 * pace.speed_m_per_s;
  return settings;
}

Estimate lowerEnd(const KnownAxis& axis) {
  return {axis.travel.low_m, std::max(axis.count_m(), 1e-5)};
}

TravelHomingOptions homingOver(const KnownAxis& axis, const TravelPace& pace) {
  TravelHomingOptions options;
  options.travel = axis.travel;
  options.searchSpeed_m_per_s = 0.2 * pace.speed_m_per_s;
  options.acceleration_m_per_s2 = pace.acceleration_m_per_s2;
  options.approachSpeed_m_per_s = 0.02 * pace.speed_m_per_s;
  options.count_m = axis.count_m();
  options.backOff_m = std::max(0.002, 20.0 * axis.count_m());
  return options;
}

TravelSweepOptions velocitySweepOver(const KnownAxis& axis, const TravelPace& pace, const TravelBins& bins,
                                     std::span<const double> parts, double run_s) {
  TravelSweepOptions options;
  options.travel = axis.travel;
  options.bins = bins;
  const double slowest = std::max(0.012, axis.travel.usable_m() / (2.4 * run_s * pace.speed_m_per_s));
  for (const double part : parts) {
    const double speed = std::max(part, slowest) * pace.speed_m_per_s;
    auto& speeds = options.speeds_m_per_s;
    if (std::find(speeds.begin(), speeds.end(), speed) == speeds.end()) speeds.push_back(speed);
  }
  options.acceleration_m_per_s2 = pace.acceleration_m_per_s2;
  options.run_s = run_s;
  options.zeroing_s = zeroing_s(axis);
  options.index_m = axis.index_m;
  options.indexTolerance_m = axis.indexTolerance();
  return options;
}

TravelBreakawayOptions breakawaySweepOver(const KnownAxis& axis, const TravelPace& pace, const TravelBins& bins,
                                          size_t passes, const std::array<std::vector<double>, 2>& moving_A) {
  const IdentifiedMotor& motor = axis.motor;
  TravelBreakawayOptions options;
  options.travel = axis.travel;
  options.bins = bins;
  options.passes = passes;
  options.forceConstant_N_per_A = axis.forcePerAmpere();
  options.resistance_ohm = axis.shownResistance_ohm;
  options.deadZone_V = axis.linearised ? 0.0 : motor.deadZone_V.value;
  options.mass_kg = motor.inertia_kg_m2.value;
  options.backEmfConstant_V_s_per_m = motor.backEmfConstant_V_s_per_rad.value;
  options.moving_A = moving_A;
  options.current_limit_A = axis.current_limit_A;
  options.speed_m_per_s = 0.3 * pace.speed_m_per_s;
  options.acceleration_m_per_s2 = pace.acceleration_m_per_s2;
  options.count_m = axis.count_m();
  options.motionVelocity_m_per_s = std::max(3e-4, 300.0 * axis.count_m());
  options.zeroing_s = zeroing_s(axis);
  options.zeroEvery_s = 20.0 * std::max(0.5, options.zeroing_s);
  options.index_m = axis.index_m;
  options.indexTolerance_m = axis.indexTolerance();
  return options;
}

std::vector<std::pair<std::string, double>> settingsOf(const TravelBreakawayOptions& measured, const TravelPace& pace,
                                                       size_t missed) {
  return {{"force_constant_N_per_A", measured.forceConstant_N_per_A},
          {"resistance_ohm", measured.resistance_ohm},
          {"dead_zone_V", measured.deadZone_V},
          {"mass_kg", measured.mass_kg},
          {"dwell_s", measured.dwell_s},
          {"settle_s", measured.settle_s},
          {"ramp_s", measured.ramp_s},
          {"motion_velocity_m_per_s", measured.motionVelocity_m_per_s},
          {"motion_counts", static_cast<double>(measured.motionCounts)},
          {"travel_m", measured.travel.high_m - measured.travel.low_m},
          {"margin_m", measured.travel.margin_m},
          {"highest_speed_m_per_s", pace.speed_m_per_s},
          {"missed", static_cast<double>(missed)}};
}

TravelFrictionOptions frictionOver(const KnownAxis& axis, const TravelBins& bins, double zeroError_A) {
  TravelFrictionOptions options;
  options.forceConstant_N_per_A = axis.forcePerAmpere();
  options.mass_kg = axis.motor.inertia_kg_m2.value;
  options.noiseRms_A = axis.noiseRms_A;
  options.zeroError_A = zeroError_A;
  options.tick_s = 1.0 / axis.board.loopRate_Hz;
  options.count_m = axis.count_m();
  options.bins = bins;
  return options;
}

}  // namespace breakaway
