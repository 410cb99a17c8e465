// What the reports on a rotor and on a linear axis have in common: the motor, the map at work, and the end.
#pragma once

#include <string>

#include "commission/known.h"
#include "draw/html_report.h"

namespace breakaway {

/// "1.23 mNm (1.20 to 1.26)", value and 95 % interval times `scale`.
Message withInterval(const Estimate& estimate, double scale, const Message& unit);
inline Message withInterval(const Estimate& estimate, double scale, const char* unit) {
  return withInterval(estimate, scale, Message(unit));
}

/// The identified motor with its intervals, and the bridge's curve where it bends.
void motorChapter(HtmlReport& report, const Commission& done);
/// What the map gained on the board, and the controller that is left.
void useChapter(HtmlReport& report, const Commission& done);
/// All remarks, and whether the board was a simulated one.
void closingChapter(HtmlReport& report, const Commission& done, bool hasTruth);

}  // namespace breakaway
