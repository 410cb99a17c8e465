// From the files of a rig to a diagnosis in a folder.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/diagnosis.h"

namespace breakaway::cli {

/// The files to diagnose, and the folder for diagnosis.json, models, report and figures.
struct DiagnosedFiles {
  std::string bench, out;
  std::vector<std::string> recordings, heldout;
  unsigned seed = 1;
  double time_s = std::numeric_limits<double>::infinity();  ///< what it may take
};

/// Reads the files, diagnoses from them alone and writes the folder; progress goes to a terminal.
Result<Diagnosis> diagnoseFiles(const DiagnosedFiles& files);

}  // namespace breakaway::cli
