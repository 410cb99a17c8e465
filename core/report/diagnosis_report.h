// The diagnosis as a technician reads it: verdict, place, cause, size and gain in pictures.
#pragma once

#include <string>
#include <vector>

#include "base/catalogue.h"
#include "base/result.h"
#include "diagnose/diagnosis.h"
#include "recording/recording.h"

namespace breakaway {

/// Writes diagnosis.json, base_model.json, model.json, report.html and figures/*.svg into `folder`, which is created;
/// report and figures in `language`, what programs read in English.
Result<void> writeDiagnosisFolder(const Diagnosis& diagnosis, const Bench& bench,
                                  const std::vector<Recording>& recordings, const std::vector<Recording>& heldout,
                                  const std::string& folder, const Catalogue& language = {});

}  // namespace breakaway
