// A run of a project in words: what kind it is, when it was, and what came out.
#pragma once

#include <QString>
#include <string>

#include "project/run.h"

namespace breakaway {

/// "Friction map" of commission and map, "Recording", …; a kind without words as it is.
QString kindInWords(const std::string& kind);
/// "2026-03-02 10:14", by the clock on the wall.
QString timeInWords(const ProjectRun& run);
/// "Friction map of 2026-03-02 10:14 (before greasing)".
QString titleOf(const ProjectRun& run);
/// A diagnosis' verdict, averages with intervals, a recording's length, or how far it came.
QString resultInWords(const ProjectRun& run);

}  // namespace breakaway
