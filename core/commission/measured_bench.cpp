#include "commission/measured_bench.h"

#include <algorithm>

namespace breakaway {

Bench measuredBench(const Commission& done, const CommissionOptions& options, double shownResistance_ohm) {
  const IdentifiedMotor& motor = done.motor;
  Bench bench = options.bench ? *options.bench : Bench{};
  if (bench.name.empty()) bench.name = options.rig;
  bench.axis = done.identity.axis;
  bench.input = DriveInput::current;
  bench.supply_V = done.identity.supply_V;
  bench.dutyCurve = motor.dutyCurve;
  bench.countsPerUnit = done.identity.countsPerRev;
  bench.motor.torqueConstant = motor.torquePerShownAmpere_Nm();
  bench.motor.backEmfConstant = motor.backEmfConstant_V_s_per_rad.value;
  bench.motor.resistance_ohm = shownResistance_ohm;
  if (motor.inductance_H.value > 0.0) bench.motor.inductance_H = motor.inductance_H.value / motor.currentGain.value;
  bench.motor.inertia = motor.inertia_kg_m2.value;
  bench.motor.viscous = std::max(0.0, motor.viscous_Nm_s_per_rad.value);
  bench.motor.coulomb = std::max(0.0, motor.coulomb_Nm.value);
  bench.trusted.insert(motorNames(bench.axis).torqueConstant);
  return bench;
}

}  // namespace breakaway
