#include "report/commission.h"

#include <algorithm>

#include "report/commission_job.h"
#include "report/compensated_run.h"
#include "report/final_tuning.h"

namespace breakaway {

std::optional<double> CommissionJob::trustedTorqueConstant() const {
  if (!options_.bench || !options_.bench->trusted.contains("torque_constant_Nm_per_A")) return {};
  return options_.bench->motor.torqueConstant;
}

/// Fresh, or from what was kept, if that belongs to this job.
Result<void> CommissionJob::begin() {
  static_cast<void>(drive_.linearise({}));  // an earlier job's curve; a board that takes none has none
  CommissionProgress fresh;
  fresh.device = done_.identity.device;
  fresh.bins = options_.bins;
  fresh.turns = options_.turns;
  fresh.speedRun_s = options_.speedRun_s;
  fresh.trustedTorqueConstant_Nm_per_A = trustedTorqueConstant();
  fresh.addedInertia_kg_m2 = options_.addedInertia_kg_m2.value;
  kept_ = options_.earlier.value_or(fresh);
  if (!options_.earlier) return {};
  if (kept_.device != fresh.device)
    return Error{"board", "is " + fresh.device + ", but the interrupted job was begun on " + kept_.device};
  if (kept_.bins != fresh.bins || kept_.turns != fresh.turns) {
    return Error{"bins and turns", "are " + std::to_string(fresh.bins) + " and " + std::to_string(fresh.turns) +
                                       ", but the interrupted job was begun with " + std::to_string(kept_.bins) +
                                       " and " + std::to_string(kept_.turns)};
  }
  if (kept_.speedRun_s != fresh.speedRun_s)
    return Error{"seconds at each speed", "are others than the interrupted job was begun with, expected the same"};
  if (kept_.trustedTorqueConstant_Nm_per_A != fresh.trustedTorqueConstant_Nm_per_A)
    return Error{
        "bench",
        "trusts another torque constant than the interrupted job was begun with, expected the same bench file"};
  if (kept_.addedInertia_kg_m2 != fresh.addedInertia_kg_m2)
    return Error{"added inertia", "is another one than the interrupted job was begun with, expected the same disc"};
  ++kept_.part;
  done_.rigTime_s = kept_.rigTime_s;
  done_.remarks = kept_.remarks;
  done_.remarks.push_back("The job was interrupted and went on: part " + std::to_string(kept_.part) + " began after " +
                          std::to_string(kept_.runs.size()) + " runs and " + std::to_string(kept_.events.size()) +
                          " breakaways.");
  return {};
}

void CommissionJob::fillBench() {
  const IdentifiedMotor& motor = done_.motor;
  Bench& bench = done_.bench;
  if (options_.bench) bench = *options_.bench;
  if (bench.name.empty()) bench.name = options_.rig;
  bench.axis = Axis::rotary;
  bench.input = DriveInput::current;
  bench.supply_V = drive_.identity().supply_V;
  bench.dutyCurve = motor.dutyCurve;
  bench.countsPerUnit = drive_.identity().countsPerRev;
  // Recordings show the current as the sensor does; with it go torque constant and winding.
  bench.motor.torqueConstant = motor.torquePerShownAmpere_Nm();
  bench.motor.backEmfConstant = motor.backEmfConstant_V_s_per_rad.value;
  bench.motor.resistance_ohm = shownResistance_ohm_;
  if (motor.inductance_H.value > 0.0) bench.motor.inductance_H = motor.inductance_H.value / motor.currentGain.value;
  bench.motor.inertia = motor.inertia_kg_m2.value;
  bench.motor.viscous = std::max(0.0, motor.viscous_Nm_s_per_rad.value);
  bench.motor.coulomb = std::max(0.0, motor.coulomb_Nm.value);
  bench.trusted.insert("torque_constant_Nm_per_A");
  bench.controller = controllerOf(done_.settings);
}

/// The measurements ran with careful gains; the board is left with those that the motor, as it is known now, allows.
void CommissionJob::tuneForUse() {
  const auto medium = mediumSettings(done_, done_.settings);
  const auto accepted = medium ? drive_.configure(*medium) : medium;
  if (!accepted) {
    done_.remarks.push_back("The controller is left as it was for the measurements: " + accepted.error().message() +
                            ".");
    return;
  }
  done_.settings = *accepted;
  done_.bench.controller = controllerOf(done_.settings);
}

Result<Commission> CommissionJob::run() {
  done_.identity = drive_.identity();
  done_.addedInertia_kg_m2 = options_.addedInertia_kg_m2;
  if (!(done_.identity.countsPerRev > 0.0)) return Error{"board", "has no encoder, which everything here rests on"};
  if (!done_.identity.hasIndex) return Error{"board", "has an encoder without index, which homing needs"};
  if (options_.against && options_.against->addedInertia_kg_m2.value == options_.addedInertia_kg_m2.value)
    return Error{"added inertia", "is the same as in the motor's file that it is held against, expected another one"};
  if (const auto ok = begin(); !ok) return ok.error();
  if (const auto ok = identify(); !ok) return ok.error();
  if (const auto ok = tune(); !ok) return ok.error();
  if (const auto ok = reverse(); !ok) return ok.error();
  fitWindings();
  if (const auto ok = setScale(); !ok) return ok.error();
  if (options_.motorOnly) {
    drive_.stop("the motor is identified");
    fillBench();
    return std::move(done_);
  }
  if (const auto ok = home(); !ok) return ok.error();
  if (const auto ok = sweepVelocity(); !ok) return ok.error();
  if (const auto ok = sweepBreakaway(); !ok) return ok.error();
  if (const auto ok = turnSlowly(); !ok) return ok.error();
  fillBench();
  tuneForUse();
  if (const auto ok = runCompensated(drive_, steps_, done_); !ok) return ok.error();
  drive_.stop("the job is done");
  return std::move(done_);
}

Result<Commission> commission(Drive& drive, const CommissionOptions& options) {
  auto result = CommissionJob(drive, options).run();
  if (!result) drive.stop(result.error().message());
  return result;
}

}  // namespace breakaway
