#include "commission/measured_bench.h"

#include <algorithm>

namespace breakaway {

namespace {

BenchController controllerOf(const ControllerSettings& settings) {
  return {ControlMode::velocity,
          settings.velocity_kp_A_s_per_rad,
          settings.velocity_ki_A_per_rad,
          settings.velocity_kd_A_s2_per_rad,
          settings.observer_cutoff_rad_per_s,
          settings.nominal_inertia_kg_m2,
          settings.nominal_torque_constant_Nm_per_A,
          settings.current_limit_A};
}

/// What is measured takes the place of what was trusted; a trusted inertia was the scale that the current was measured
/// by, and stays.
void withdrawTrust(Bench& bench) {
  const bool inertia = bench.trusted.contains(motorNames(bench.axis).inertia);
  bench.trusted.clear();
  if (inertia) bench.trusted.insert(motorNames(bench.axis).inertia);
}

}  // namespace

Bench measuredBench(const Commission& done, const CommissionOptions& options) {
  const IdentifiedMotor& motor = done.motor;
  Bench bench = options.bench ? *options.bench : Bench{};
  if (bench.name.empty()) bench.name = options.rig;
  bench.axis = done.identity.axis;
  bench.input = DriveInput::current;
  bench.supply_V = done.identity.supply_V;
  bench.dutyCurve = motor.dutyCurve;
  bench.countsPerUnit = done.identity.countsPerRev;
  bench.motor.torqueConstant = motor.torquePerShownAmpere_Nm();
  withdrawTrust(bench);
  bench.remarks = done.map.remarks;
  if (!done.knows(Known::map)) bench.remarks.assign(done.contradictions.begin(), done.contradictions.end());
  bench.motor.backEmfConstant = motor.backEmfConstant_V_s_per_rad.value;
  bench.motor.resistance_ohm = done.shownResistance_ohm;
  if (motor.inductance_H.value > 0.0) bench.motor.inductance_H = motor.inductance_H.value / motor.currentGain.value;
  bench.motor.inertia = motor.inertia_kg_m2.value;
  bench.motor.viscous = std::max(0.0, motor.viscous_Nm_s_per_rad.value);
  bench.motor.coulomb = std::max(0.0, motor.coulomb_Nm.value);
  bench.trusted.insert(motorNames(bench.axis).torqueConstant);
  if (done.facts.hasAny({Known::carefulGains, Known::gainsInUse})) bench.controller = controllerOf(done.settings);
  return bench;
}

}  // namespace breakaway
