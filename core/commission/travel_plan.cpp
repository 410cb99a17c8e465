#include "commission/travel_plan.h"

#include <algorithm>
#include <cmath>

#include "commission/sweep_layout.h"

namespace breakaway {

Travel moved(const Travel& travel, double by_m) {
  return {travel.low_m + by_m, travel.high_m + by_m, travel.margin_m};
}

bool sameEnds(const Travel& before, const Travel& now) {
  constexpr double part = 0.01;
  const double most_m = part * (before.high_m - before.low_m);
  return std::abs(before.low_m - now.low_m) <= most_m && std::abs(before.high_m - now.high_m) <= most_m;
}

double count_m(const Commission& axis) {
  return 1.0 / axis.identity.countsPerRev;
}

namespace {

double toleranceOf(const Commission& axis) {
  return axis.identity.hasIndex ? indexTolerance_m(count_m(axis)) : 0.0;
}

}  // namespace

TravelPace paceOf(const Commission& axis) {
  const IdentifiedMotor& motor = axis.identified;
  const double friction_A = std::max(0.01, motor.coulomb_Nm.value / motor.torqueConstant_Nm_per_A.value);
  const double spare_A = std::max(0.2 * friction_A, 0.5 * (axis.settings.current_limit_A - friction_A));
  TravelPace pace;
  pace.acceleration_m_per_s2 =
      motor.torquePerShownAmpere_Nm() * std::min(1.5 * friction_A, spare_A) / motor.inertia_kg_m2.value;
  const double supply_V = axis.identity.supply_V;
  const double usable_V = supply_V - motor.deadZone_V.value - 3.0 * axis.shownResistance_ohm * friction_A;
  const double byTravel = std::sqrt(2.0 * pace.acceleration_m_per_s2 * 0.3 * axis.counted.usable_m());
  pace.speed_m_per_s =
      std::min(byTravel, std::max(0.05 * supply_V, 0.7 * usable_V) / motor.backEmfConstant_V_s_per_rad.value);
  return pace;
}

Estimate lowerEnd(const Commission& axis) {
  return {axis.counted.low_m, std::max(count_m(axis), 1e-5)};
}

TravelHomingOptions homingOver(const Commission& axis) {
  TravelHomingOptions options;
  options.travel = axis.counted;
  options.searchSpeed_m_per_s = 0.2 * axis.pace.speed_m_per_s;
  options.acceleration_m_per_s2 = axis.pace.acceleration_m_per_s2;
  options.approachSpeed_m_per_s = 0.02 * axis.pace.speed_m_per_s;
  options.count_m = count_m(axis);
  options.backOff_m = std::max(0.002, 20.0 * count_m(axis));
  return options;
}

TravelBins binsOver(const Commission& axis) {
  const Travel travel = axis.counted;
  return {travel.first_m(), travel.last_m(), axis.sweeps.bins};
}

TravelSweepOptions velocitySweepOver(const Commission& axis, std::span<const double> parts) {
  TravelSweepOptions options;
  options.travel = axis.counted;
  options.bins = binsOver(axis);
  const double run_s = axis.sweeps.speedRun_s, asked = axis.sweeps.highest_rad_per_s;
  const double highest = asked > 0.0 ? std::min(asked, axis.pace.speed_m_per_s) : axis.pace.speed_m_per_s;
  const double slowest = std::max(0.012, axis.counted.usable_m() / (2.4 * run_s * highest));
  for (const double part : parts) {
    const double speed = std::max(part, slowest) * highest;
    auto& speeds = options.speeds_m_per_s;
    if (std::find(speeds.begin(), speeds.end(), speed) == speeds.end()) speeds.push_back(speed);
  }
  options.acceleration_m_per_s2 = axis.pace.acceleration_m_per_s2;
  options.run_s = run_s;
  options.windingTime_s = windingTime_s(axis);
  options.steadiness = {axis.torquePerAmpere_Nm() / axis.motor.inertia_kg_m2.value, axis.noiseRms_A};
  options.zeroing_s = sensorZeroing_s(axis);
  options.index_m = axis.indexAngle_rad.value;
  options.indexTolerance_m = toleranceOf(axis);
  return options;
}

TravelBreakawayOptions breakawaySweepOver(const Commission& axis, const std::array<std::vector<double>, 2>& moving_A) {
  const IdentifiedMotor& motor = axis.motor;
  TravelBreakawayOptions options;
  options.travel = axis.counted;
  options.bins = binsOver(axis);
  options.passes = axis.sweeps.turns;
  options.torqueConstant_Nm_per_A = axis.torquePerAmpere_Nm();
  options.resistance_ohm = axis.shownResistance_ohm;
  options.deadZone_V = axis.linearised ? 0.0 : motor.deadZone_V.value;
  options.windingTime_s = windingTime_s(axis);
  options.inertia_kg_m2 = motor.inertia_kg_m2.value;
  options.backEmfConstant_V_s_per_rad = motor.backEmfConstant_V_s_per_rad.value;
  options.moving_A = moving_A;
  options.current_limit_A = axis.settings.current_limit_A;
  options.speed_m_per_s = 0.3 * axis.pace.speed_m_per_s;
  options.acceleration_m_per_s2 = axis.pace.acceleration_m_per_s2;
  options.count_m = count_m(axis);
  options.motionVelocity_rad_per_s = std::max(3e-4, 300.0 * count_m(axis));
  options.zeroing_s = sensorZeroing_s(axis);
  options.zeroEvery_s = 20.0 * std::max(0.5, options.zeroing_s);
  options.index_m = axis.indexAngle_rad.value;
  options.indexTolerance_m = toleranceOf(axis);
  return options;
}

TravelFrictionOptions frictionOver(const Commission& axis) {
  TravelFrictionOptions options;
  options.forceConstant_N_per_A = axis.torquePerAmpere_Nm();
  options.mass_kg = axis.motor.inertia_kg_m2.value;
  options.massError_kg = axis.identified.shownInertia_kg_m2.standardError;
  options.noiseRms_A = axis.noiseRms_A;
  options.zeroError_A = axis.runsZeroError_A;
  options.scaleError = torqueScaleError(axis);
  options.tick_s = 1.0 / axis.identity.loopRate_Hz;
  options.count_m = count_m(axis);
  options.bins = binsOver(axis);
  return options;
}

}  // namespace breakaway
