// A commissioned axis' friction as a chapter of the report: around a rotor, or over a travel.
#pragma once

#include "commission/known.h"
#include "draw/html_report.h"

namespace breakaway {

/// Friction as the map has it.
void frictionChapter(HtmlReport& report, const Commission& done);
/// Before there is a map: what the velocity sweep tells alone, and how far the breakaway sweep is.
void unfinishedChapter(HtmlReport& report, const Commission& done);

}  // namespace breakaway
