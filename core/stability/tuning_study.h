// A tuning with all that shows what it is: root locus, response, bounds and noise.
#pragma once

#include "base/axis.h"
#include "stability/inner_loops.h"
#include "stability/root_locus.h"

namespace breakaway {

struct TuningStudy {
  Axis axis = Axis::rotary;  ///< linear: read m for rad, kg for kg m², N for Nm, and files name them so
  Estimate inertia_kg_m2, torqueConstant_Nm_per_A;
  SensorNoise sensors;
  InnerLoops inner;  ///< the speed observer and the current loop that it was tuned with
  Tuning tuning;
  ServoLoop loop;  ///< the tuned velocity loop around the nominal motor
  CutoffBounds bounds;
  RootLocus locus;                  ///< over the cutoff, the gains as tuned
  LoopResponse velocity, position;  ///< nominal
  ClosedResponse velocityClosed, positionClosed;
  std::vector<double> cutoffs_rad_per_s;  ///< of `noise`
  std::vector<LoopNoise> noise;           ///< over the cutoff, the gains as tuned; NaN where unstable
};

/// chooseInnerLoops(), autoTune() with what that chose, and around its result 300 cutoffs from a tenth of it up to
/// where the loop becomes unstable (at most 2/T), 400 frequencies up to π/T, 60 cutoffs of noise. Errors: those of
/// both.
Result<TuningStudy> studyTuning(ServoLoop loop, const Estimate& inertia_kg_m2, const Estimate& torqueConstant_Nm_per_A,
                                const AutoTuningOptions& options, const InnerLoopOptions& inner);

}  // namespace breakaway
