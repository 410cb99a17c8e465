// What came out of a run of a project, in words.
#pragma once

#include <QString>
#include <vector>

#include "session/run_title.h"

namespace breakaway {

/// A diagnosis' verdict, averages with intervals, a recording's length, or how far it came.
QString resultInWords(const ProjectRun& run);
/// The run's values, what a person looks for first at the top: averages, then the motor's constants, then the rest.
std::vector<RunValue> byImportance(const ProjectRun& run);

}  // namespace breakaway
