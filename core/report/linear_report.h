// A commissioned linear axis in words and as a chapter of the report, drawn over its travel.
#pragma once

#include <string>

#include "commission/known.h"
#include "draw/html_report.h"

namespace breakaway {

/// Mean force at each speed of the strokes, by way.
Figure strokesFigure(const Commission& done);
/// Friction as the map has it.
void travelChapter(HtmlReport& report, const Commission& done);
/// The averages in a few lines of plain text.
std::string linearInWords(const Commission& done);

}  // namespace breakaway
