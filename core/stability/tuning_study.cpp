#include "stability/tuning_study.h"

#include <algorithm>
#include <numbers>

namespace breakaway {

Result<TuningStudy> studyTuning(ServoLoop loop, const Estimate& inertia_kg_m2, const Estimate& torqueConstant_Nm_per_A,
                                const AutoTuningOptions& options, const InnerLoopOptions& inner) {
  auto chosen = chooseInnerLoops(loop, inertia_kg_m2, torqueConstant_Nm_per_A, options, inner);
  if (!chosen) return chosen.error();
  loop.board.current.bandwidth_rad_per_s = chosen->current.bandwidth_rad_per_s;
  loop.board.velocityBandwidth_rad_per_s = chosen->observer.bandwidth_rad_per_s;
  auto tuning = autoTune(loop, inertia_kg_m2, torqueConstant_Nm_per_A, options);
  if (!tuning) return tuning.error();
  TuningStudy study;
  study.inertia_kg_m2 = inertia_kg_m2;
  study.torqueConstant_Nm_per_A = torqueConstant_Nm_per_A;
  study.sensors = options.noise;
  study.inner = std::move(*chosen);
  study.tuning = std::move(*tuning);
  study.loop = loop;
  study.loop.mode = ServoMode::velocity;
  study.loop.settings = study.tuning.settings;
  study.loop.motor.inertia_kg_m2 = inertia_kg_m2.value;
  study.loop.motor.torqueConstant_Nm_per_A = torqueConstant_Nm_per_A.value;
  study.bounds = cutoffBounds(study.loop);
  const double T = loop.board.tick_s, cutoff = study.tuning.settings.observer_cutoff_rad_per_s;
  const double highest =
      std::max(2.0 * cutoff, std::min(2.0 / T, 1.2 * study.bounds.unstable_rad_per_s.value_or(2.0 / T)));
  study.locus = rootLocus(study.loop, decades(0.1 * cutoff, highest, 300));
  const auto frequencies = decades(0.01 * cutoff, std::numbers::pi / T, 400);
  study.velocity = loopResponse(study.loop, frequencies);
  ServoLoop positioned = study.loop;
  positioned.mode = ServoMode::position;
  study.position = loopResponse(positioned, frequencies);
  study.velocityClosed = closedResponse(study.loop, frequencies);
  study.positionClosed = closedResponse(positioned, frequencies);
  study.cutoffs_rad_per_s = decades(0.1 * cutoff, highest, 60);
  study.noise = noiseOverCutoff(study.loop, options.noise, study.cutoffs_rad_per_s);
  return study;
}

}  // namespace breakaway
