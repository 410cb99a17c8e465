#include "stability/bench_loop.h"

#include "control/tuning.h"

namespace breakaway {

Result<ServoLoop> loopOfBench(const Bench& bench, const BoardTiming& timing) {
  const MotorBelief& motor = bench.motor;
  const auto torqueConstant = motor.torqueConstant ? motor.torqueConstant : motor.backEmfConstant;
  const MotorNames& names = motorNames(bench.axis);
  const auto missing = [](const char* name) {
    return Error{std::string("field motor.") + name, message("is missing, expected the identified one")};
  };
  if (!torqueConstant) return missing(names.torqueConstant);
  if (!motor.inertia) return missing(names.inertia);
  ServoLoop loop;
  loop.delay_ticks = timing.delay_ticks;
  loop.motor = {*motor.inertia,
                *torqueConstant,
                motor.viscous.value_or(0.0),
                motor.resistance_ohm.value_or(0.0),
                motor.inductance_H.value_or(0.0),
                motor.backEmfConstant.value_or(*torqueConstant)};
  const bool wound = motor.resistance_ohm && motor.inductance_H;
  loop.current = wound ? CurrentPath::winding : CurrentPath::ideal;
  loop.board = {timing.tick_s,
                bench.count(),
                {loop.motor.resistance_ohm, loop.motor.inductance_H, loop.motor.backEmfConstant_V_s_per_rad,
                 boardCurrentBandwidth_rad_per_s(timing.tick_s)},
                boardVelocityBandwidth_rad_per_s(timing.tick_s)};
  const BenchController& controller = bench.controller;
  loop.settings.inertia_kg_m2 = *motor.inertia;
  loop.settings.torqueConstant_Nm_per_A = *torqueConstant;
  loop.settings.current_limit_A = controller.currentLimit_A;
  if (auto fine = check(loop); !fine) return fine.error();
  return loop;
}

}  // namespace breakaway
