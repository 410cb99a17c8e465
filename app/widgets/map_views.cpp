#include "widgets/map_views.h"

#include <QCoreApplication>
#include <algorithm>
#include <functional>

#include "experiment/travel_bins.h"
#include "widgets/axis_units.h"

namespace breakaway {

namespace {

QString viewWords(const char* text) {
  return QCoreApplication::translate("MapView", text);
}

/// ccw and cw keep their colours in every view.
int colourOf(Way way) {
  return way == Way::ccw ? 0 : 1;
}

std::vector<MapCurve> turnCurves(const Commission& known) {
  const char* const name = known.identity.axis == Axis::linear ? QT_TRANSLATE_NOOP("MapView", "%1, pass %2")
                                                               : QT_TRANSLATE_NOOP("MapView", "%1, turn %2");
  const std::vector<BreakawayEvent>& events = known.events.empty() ? known.breakaways : known.events;
  std::vector<MapCurve> curves;
  for (const Way way : {Way::ccw, Way::cw}) {
    for (size_t turn = 0; turn < known.sweeps.turns; ++turn) {
      MapCurve curve{viewWords(name).arg(shortWayName(way, known.identity.axis)).arg(turn + 1),
                     colourOf(way),
                     turn > 0,
                     false,
                     {}};
      for (const BreakawayEvent& event : events) {
        if (event.way == way && event.turn == turn)
          curve.points.push_back(
              {event.angle_rad, unitsOf(known.identity.axis).torqueScale * event.torque_Nm, 0.0, event.outlier});
      }
      if (curve.points.empty()) continue;
      std::sort(curve.points.begin(), curve.points.end(),
                [](const MapPoint& a, const MapPoint& b) { return a.at < b.at; });
      curve.closed = curve.points.size() >= known.sweeps.bins;
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

using Read = std::function<Estimate(const WayBin&)>;

std::vector<MapCurve> wayCurves(const FrictionMap& map, double scale, const Read& read) {
  std::vector<MapCurve> curves;
  for (const Way way : {Way::ccw, Way::cw}) {
    MapCurve curve{shortWayName(way, map.axis), colourOf(way), false, true, {}};
    for (const MapBin& bin : map.bins) {
      const WayBin& one = bin.way[static_cast<size_t>(way)];
      const Estimate estimate = read(one);
      curve.points.push_back({bin.angle_rad, scale * estimate.value, scale * estimate.standardError, one.outlier});
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

/// The moving friction before there is a map of breakaways: over the bins that strokes were taken apart into.
std::vector<MapCurve> movingCurves(const Commission& known, double scale, std::vector<Estimate> MovingFriction::*read) {
  if (!known.travel) return {};
  const TravelBins places{known.travel->first_m(), known.travel->last_m(), known.sweeps.bins};
  std::vector<MapCurve> curves;
  for (const Way way : {Way::ccw, Way::cw}) {
    MapCurve curve{shortWayName(way, known.identity.axis), colourOf(way), false, true, {}};
    const std::vector<Estimate>& values = known.moving[static_cast<size_t>(way)].*read;
    for (size_t k = 0; k < values.size(); ++k)
      curve.points.push_back({places.centre_m(k), scale * values[k].value, scale * values[k].standardError, false});
    curves.push_back(std::move(curve));
  }
  return curves;
}

MapCurve positionCurve(const FrictionMap& map) {
  const bool linear = map.axis == Axis::linear;
  MapCurve curve{linear ? viewWords(QT_TRANSLATE_NOOP("MapView", "position force"))
                        : viewWords(QT_TRANSLATE_NOOP("MapView", "position torque")),
                 3,
                 false,
                 true,
                 {}};
  for (const MapBin& bin : map.bins)
    curve.points.push_back({bin.angle_rad, unitsOf(map.axis).torqueScale * bin.positionTorque_Nm(), 0.0, false});
  return curve;
}

}  // namespace

QString nameOf(MapView view, Axis axis) {
  const bool linear = axis == Axis::linear;
  switch (view) {
    case MapView::turns:
      return linear ? viewWords(QT_TRANSLATE_NOOP("MapView", "Breakaway, pass by pass"))
                    : viewWords(QT_TRANSLATE_NOOP("MapView", "Breakaway, turn by turn"));
    case MapView::staticMean:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Static friction, mean"));
    case MapView::coulomb:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Coulomb friction"));
    case MapView::viscous:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Viscous coefficient"));
    case MapView::total:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Total at the map's speed"));
    case MapView::positionTorque:
      return linear ? viewWords(QT_TRANSLATE_NOOP("MapView", "Position force"))
                    : viewWords(QT_TRANSLATE_NOOP("MapView", "Position torque"));
  }
  return {};
}

QString shortNameOf(MapView view) {
  switch (view) {
    case MapView::turns:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Breakaway"));
    case MapView::staticMean:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Static"));
    case MapView::coulomb:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Coulomb"));
    case MapView::viscous:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Viscous"));
    case MapView::total:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Total"));
    case MapView::positionTorque:
      return viewWords(QT_TRANSLATE_NOOP("MapView", "Position"));
  }
  return {};
}

QString obstacleTo(MapView view, const Commission& known) {
  if (view == MapView::turns)
    return known.breakaways.empty() ? viewWords(QT_TRANSLATE_NOOP("MapView", "Run the breakaway sweep first"))
                                    : QString();
  const bool moving = view == MapView::coulomb || view == MapView::viscous || view == MapView::total;
  // A linear axis has moving friction over its travel before it has breakaways.
  if (known.identity.axis == Axis::linear && (view == MapView::coulomb || view == MapView::viscous))
    return known.knows(Known::runs) ? QString()
                                    : viewWords(QT_TRANSLATE_NOOP("MapView", "Run the velocity sweep first"));
  if (!known.knows(Known::map))
    return viewWords(QT_TRANSLATE_NOOP("MapView", "Run the breakaway sweep to its end first"));
  return moving && !known.knows(Known::runs) ? viewWords(QT_TRANSLATE_NOOP("MapView", "Run the velocity sweep first"))
                                             : QString();
}

namespace {

QString titled(const char* quantity, const QString& unit) {
  return viewWords(quantity).arg(unit);
}

QString breakawayTitle(Axis axis) {
  return titled(axis == Axis::linear ? QT_TRANSLATE_NOOP("MapView", "breakaway force (%1)")
                                     : QT_TRANSLATE_NOOP("MapView", "breakaway torque (%1)"),
                unitsOf(axis).torque);
}

QString coulombTitle(Axis axis) {
  return titled(QT_TRANSLATE_NOOP("MapView", "Coulomb friction (%1)"), unitsOf(axis).torque);
}

QString viscousTitle(Axis axis) {
  return titled(QT_TRANSLATE_NOOP("MapView", "viscous coefficient (%1)"), unitsOf(axis).viscous);
}

}  // namespace

MapPicture pictureOf(MapView view, const FrictionMap& map) {
  const AxisUnits units = unitsOf(map.axis);
  switch (view) {
    case MapView::turns:
    case MapView::staticMean:
      return {wayCurves(map, units.torqueScale, [](const WayBin& bin) { return bin.static_Nm; }),
              titled(QT_TRANSLATE_NOOP("MapView", "static friction (%1)"), units.torque), units.torque};
    case MapView::coulomb:
      return {wayCurves(map, units.torqueScale, [](const WayBin& bin) { return bin.coulomb_Nm; }),
              coulombTitle(map.axis), units.torque};
    case MapView::viscous:
      return {wayCurves(map, units.viscousScale, [](const WayBin& bin) { return bin.viscous_Nm_s_per_rad; }),
              viscousTitle(map.axis), units.viscous};
    case MapView::total:
      return {wayCurves(map, units.torqueScale,
                        [](const WayBin& bin) {
                          return Estimate{bin.total_Nm, 0.0};
                        }),
              viewWords(QT_TRANSLATE_NOOP("MapView", "total at %1 %2 (%3)"))
                  .arg(map.totalVelocity_rad_per_s, 0, 'f', 2)
                  .arg(units.speed, units.torque),
              units.torque};
    case MapView::positionTorque:
      return {{positionCurve(map)},
              map.axis == Axis::linear ? titled(QT_TRANSLATE_NOOP("MapView", "position force (%1)"), units.torque)
                                       : titled(QT_TRANSLATE_NOOP("MapView", "position torque (%1)"), units.torque),
              units.torque};
  }
  return {};
}

MapPicture pictureOf(MapView view, const Commission& known) {
  const Axis axis = known.identity.axis;
  const AxisUnits units = unitsOf(axis);
  if (view == MapView::turns) return {turnCurves(known), breakawayTitle(axis), units.torque};
  if (known.knows(Known::map)) return pictureOf(view, known.map);
  if (axis == Axis::linear && known.knows(Known::runs) && view == MapView::coulomb)
    return {movingCurves(known, units.torqueScale, &MovingFriction::coulomb_Nm), coulombTitle(axis), units.torque};
  if (axis == Axis::linear && known.knows(Known::runs) && view == MapView::viscous)
    return {movingCurves(known, units.viscousScale, &MovingFriction::viscous_Nm_s_per_rad), viscousTitle(axis),
            units.viscous};
  return {{}, breakawayTitle(axis), units.torque};
}

}  // namespace breakaway
