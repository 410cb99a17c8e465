// The measured friction as one HTML file that a customer can read.
#pragma once

#include <string>

#include "base/result.h"
#include "experiment/drive.h"
#include "friction_survey.h"

namespace breakaway {

/// Writes motor, averages with intervals, repeatability and the polar pictures of what was measured. Errors: nothing
/// was measured; the file.
Result<void> writeSurveyReport(const FrictionSurvey& survey, const Identity& identity, const std::string& path);

}  // namespace breakaway
