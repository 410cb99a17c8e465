// What a run of a project is called: its kind and when it was.
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

}  // namespace breakaway
