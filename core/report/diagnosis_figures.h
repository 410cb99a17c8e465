// The diagnosis in pictures: motion and residual before and after, the places, the gain.
#pragma once

#include <string>
#include <vector>

#include "diagnose/diagnosis.h"
#include "draw/svg_plot.h"
#include "recording/recording.h"

namespace breakaway {

/// One picture of the report, also written as figures/NAME.svg.
struct NamedFigure {
  std::string name;
  Saying caption;
  Figure figure;
};

/// Measured over simulated in the worst and in a typical held-out window, the residual of the whole first recording,
/// the unexplained over the axes where it showed, before and after, and each finding's term with its interval.
std::vector<NamedFigure> diagnosisFigures(const Diagnosis& diagnosis, const std::vector<Recording>& recordings,
                                          const std::vector<Recording>& heldout);

}  // namespace breakaway
