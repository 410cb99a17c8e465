// What has changed between two runs as a page of text: what lies beyond the intervals first.
#pragma once

#include <QString>

#include "report/run_comparison.h"

namespace breakaway {

/// "Friction map of 2026-03-02 10:14 → Friction map of 2026-04-01 09:00"
QString titleOf(const RunComparison& comparison);
/// HTML with one table of results and one of the maps' means, those beyond their intervals in bold.
QString pageOf(const RunComparison& comparison);

}  // namespace breakaway
