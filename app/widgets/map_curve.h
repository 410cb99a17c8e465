// What a plot of the friction map draws: one curve per way and turn, in shown units.
#pragma once

#include <QString>
#include <vector>

namespace breakaway {

struct MapPoint {
  double at = 0.0;             ///< rad from the index; m on a linear axis
  double value = 0.0;          ///< in the plot's unit
  double standardError = 0.0;  ///< 0: not known
  bool outlier = false;
};

/// What a curve is of: what is shown, an earlier map beneath it, or how they differ, drawn outside all others
/// around where they don't.
enum class MapPart { shown, earlier, difference, noDifference };

struct MapCurve {
  QString name;
  int colour = 0;  ///< of Look::curve
  bool dashed = false;
  bool closed = false;           ///< complete: around a rotor the last point joins the first
  std::vector<MapPoint> points;  ///< by growing place
  MapPart part = MapPart::shown;
  double lifted = 0.0;  ///< how much higher its values are drawn than they are
};

/// Whether it is of how the two maps differ: its values are lifted above all others.
inline bool ofDifference(const MapCurve& curve) {
  return curve.part == MapPart::difference || curve.part == MapPart::noDifference;
}

/// "20.1 ± 0.12 mNm (95 %), outlier": the value and its doubt as a hovering hand reads them.
QString readingOf(const MapPoint& point, const QString& unit);

}  // namespace breakaway
