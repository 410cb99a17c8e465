// What reports of rotors and of linear axes draw alike: a map's figures, in the units of the axis.
#pragma once

#include <array>
#include <string>

#include "base/marked_text.h"
#include "base/message.h"
#include "commission/known.h"
#include "draw/html_report.h"
#include "friction/friction_map.h"

namespace breakaway {

/// How an axis' places, torque and ways are written.
struct MapUnits {
  std::array<MessageText<0>, 2> ways;
  MessageText<0> place;  ///< axis title
  double placeScale;
  MessageText<0> torque;   ///< "torque" or "force"
  const char* torqueUnit;  ///< "mNm" or "N"
  double torqueScale;
  MessageText<0> pass, passes;  ///< "turn" or "pass", and several
  const char* viscousUnit;
  double viscousScale;
  const char* speedUnit;

  Message torqueTitle() const { return message(torque) + " / " + std::string(torqueUnit); }
};
const MapUnits& mapUnitsOf(Axis axis);
/// Of a way's curves, as the window has them: blue counter-clockwise, vermilion clockwise; see colourOf().
inline int wayColour(size_t way) {
  return way == 0 ? 1 : 0;
}

/// Nm or N.
double staticMean(const FrictionMap& map, size_t way);
/// How well consecutive turns or passes repeat: a sentence's part that begins with a lower-case letter.
Message repeatWords(const FrictionMap& map);
/// The same for a table's row: correlation, and difference in mNm or N.
std::array<std::string, 2> repeatCells(const FrictionMap& map, size_t way);
/// The breakaways that were marked as outliers; empty where there is none.
Curve outlierCurve(const FrictionMap& map, double placeScale);
/// One curve per way over the places, each with its 95 % band, times `scale`.
Figure mapFigure(const FrictionMap& map, const Message& title, const Message& yTitle, double scale,
                 Estimate (*get)(const WayBin&));
/// One curve per turn or pass.
Figure passesFigure(const FrictionMap& map, size_t way);
/// By way the `points` at constant speed, and the line through the averages.
Figure speedFigure(const Commission& done, std::array<Curve, 2> points, const Message& speedTitle);

}  // namespace breakaway
