// What the plot of a map can show of what is known: views by name, each a set of curves with its unit.
#pragma once

#include <QString>
#include <vector>

#include "commission/known.h"
#include "widgets/map_curve.h"

namespace breakaway {

enum class MapView { turns, staticMean, coulomb, viscous, total, positionTorque };

struct MapPicture {
  std::vector<MapCurve> curves;
  QString quantity;  ///< of the radius, with its unit
  QString unit;
};

QString nameOf(MapView view, Axis axis = Axis::rotary);
/// In one word, for a chip.
QString shortNameOf(MapView view);
/// Why the view has nothing to show yet; empty when it has.
QString obstacleTo(MapView view, const Commission& known);
/// Of a whole map, whatever else is known; turn by turn a map has the mean alone.
MapPicture pictureOf(MapView view, const FrictionMap& map);
/// Torques in mNm, viscous friction in µNm s/rad; N and N s/m over a linear axis' travel.
MapPicture pictureOf(MapView view, const Commission& known);

}  // namespace breakaway
