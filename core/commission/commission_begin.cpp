#include "commission/commission_begin.h"

namespace breakaway {

std::optional<double> trustedConstant(const CommissionOptions& options) {
  if (!options.bench || !options.bench->trusted.contains(motorNames(options.bench->axis).torqueConstant)) return {};
  return options.bench->motor.torqueConstant;
}

Result<void> beginProgress(const CommissionOptions& options, Commission& done, CommissionProgress& kept) {
  CommissionProgress fresh;
  fresh.device = done.identity.device;
  fresh.bins = options.bins;
  fresh.turns = options.turns;
  fresh.speedRun_s = options.speedRun_s;
  fresh.trustedTorqueConstant_Nm_per_A = trustedConstant(options);
  fresh.addedInertia_kg_m2 = options.addedInertia_kg_m2.value;
  kept = options.earlier.value_or(fresh);
  if (!options.earlier) return {};
  if (kept.device != fresh.device)
    return Error{"board", "is " + fresh.device + ", but the interrupted job was begun on " + kept.device};
  if (kept.bins != fresh.bins || kept.turns != fresh.turns) {
    return Error{"bins and turns", "are " + std::to_string(fresh.bins) + " and " + std::to_string(fresh.turns) +
                                       ", but the interrupted job was begun with " + std::to_string(kept.bins) +
                                       " and " + std::to_string(kept.turns)};
  }
  if (kept.speedRun_s != fresh.speedRun_s)
    return Error{"seconds at each speed", "are others than the interrupted job was begun with, expected the same"};
  if (kept.trustedTorqueConstant_Nm_per_A != fresh.trustedTorqueConstant_Nm_per_A)
    return Error{
        "bench",
        "trusts another torque constant than the interrupted job was begun with, expected the same bench file"};
  if (kept.addedInertia_kg_m2 != fresh.addedInertia_kg_m2)
    return Error{"added inertia", "is another one than the interrupted job was begun with, expected the same disc"};
  ++kept.part;
  done.rigTime_s = kept.rigTime_s;
  done.remarks = kept.remarks;
  done.remarks.push_back("The job was interrupted and went on: part " + std::to_string(kept.part) + " began after " +
                         std::to_string(kept.runs.size() + kept.strokes.size()) + " runs and " +
                         std::to_string(kept.events.size()) + " breakaways.");
  return {};
}

}  // namespace breakaway
