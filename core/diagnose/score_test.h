// Which effect would help most, judged without fitting it: the derivative of the windowed error by each candidate's
// amplitude.
#pragma once

#include <vector>

#include "diagnose/effect.h"
#include "diagnose/fit/windowed_fit.h"

namespace breakaway {

/// One effect at its best shape.
struct Candidate {
  const Effect* effect = nullptr;
  Shape shape;
  std::vector<double> amplitude;  ///< first estimate
  double gain = 0.0;              ///< part of the squared weighted error that it would take away, by linearisation
  double pValue = 1.0;            ///< family-wise over all candidates and shapes
};

/// The score (Lagrange multiplier) test of C. R. Rao (1948) on simulated windows: every candidate's amplitude is nudged
/// in the simulation, its effect on the residuals freed of what base parameters and initial states can do. Significance
/// by sign flips of whole windows (wild bootstrap, maximum over all candidates), so that correlation within a window
/// does no harm. Sorted by gain.
std::vector<Candidate> scoreTest(const FitResult& at, const ParameterVector& parameters,
                                 const std::vector<Track>& tracks, const std::vector<Window>& windows,
                                 const std::vector<const Effect*>& effects, const Excitation& seen, std::uint64_t seed,
                                 const std::vector<double>& windowWeights = {});

/// Mean squared position residual per window (times its squared weight), each simulated with the parameters that a fit
/// to the other folds would have: one Gauss–Newton step from the common fit.
std::vector<double> crossValidated(const FitResult& fit, const ParameterVector& parameters,
                                   const std::vector<Track>& tracks, const std::vector<Window>& windows,
                                   const std::vector<double>& windowWeights, const std::vector<int>& fold,
                                   int foldCount);

}  // namespace breakaway
