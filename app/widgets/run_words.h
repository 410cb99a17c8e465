// What came out of a run of a project, in words.
#pragma once

#include <QString>

#include "session/run_title.h"

namespace breakaway {

/// A diagnosis' verdict, averages with intervals, a recording's length, or how far it came.
QString resultInWords(const ProjectRun& run);

}  // namespace breakaway
