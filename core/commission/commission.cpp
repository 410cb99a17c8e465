#include "commission/commission.h"

#include "commission/commission_begin.h"
#include "commission/commission_job.h"
#include "commission/commission_linear.h"
#include "commission/compensated_run.h"
#include "commission/final_tuning.h"
#include "commission/measured_bench.h"

namespace breakaway {

std::optional<double> CommissionJob::trustedTorqueConstant() const {
  return trustedConstant(options_);
}

/// Fresh, or from what was kept, if that belongs to this job.
Result<void> CommissionJob::begin() {
  static_cast<void>(drive_.linearise({}));  // an earlier job's curve; a board that takes none has none
  return beginProgress(options_, done_, kept_);
}

void CommissionJob::fillBench() {
  done_.bench = measuredBench(done_, options_, shownResistance_ohm_);
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
  tuneForUse(drive_, done_);
  if (const auto ok = runCompensated(drive_, steps_, done_); !ok) return ok.error();
  drive_.stop("the job is done");
  return std::move(done_);
}

Result<Commission> commission(Drive& drive, const CommissionOptions& options) {
  const bool linear = drive.identity().axis == Axis::linear;
  auto result = linear ? commissionLinear(drive, options) : CommissionJob(drive, options).run();
  if (!result) drive.stop(result.error().message());
  return result;
}

}  // namespace breakaway
