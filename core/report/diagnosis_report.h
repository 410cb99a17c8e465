// The diagnosis as a technician reads it: verdict, place, cause, size and gain in pictures.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/diagnosis.h"
#include "report/svg_plot.h"

namespace breakaway {

/// One picture of the report, also written as figures/NAME.svg.
struct NamedFigure {
  std::string name;
  std::string caption;
  Figure figure;
};

/// Measured over simulated, the residual beneath, the unexplained torque over the axes where it showed, and each
/// finding's term with its interval; drawn from the first training recording and, for the proof, from the first
/// held-out one.
std::vector<NamedFigure> diagnosisFigures(const Diagnosis& diagnosis, const std::vector<Recording>& recordings,
                                          const std::vector<Recording>& heldout);

/// Writes diagnosis.json, base_model.json, model.json, report.html and figures/*.svg into `folder`, which is created.
Result<void> writeDiagnosisFolder(const Diagnosis& diagnosis, const Bench& bench,
                                  const std::vector<Recording>& recordings, const std::vector<Recording>& heldout,
                                  const std::string& folder);

}  // namespace breakaway
