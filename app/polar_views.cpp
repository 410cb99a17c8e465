#include "polar_views.h"

#include <QCoreApplication>
#include <algorithm>
#include <functional>

namespace breakaway {

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("PolarView", text);
}

QString wayName(Way way) {
  return way == Way::cw ? translated("clockwise") : translated("counter-clockwise");
}

/// ccw and cw keep their colours in every view.
int colourOf(Way way) {
  return way == Way::ccw ? 0 : 1;
}

std::vector<PolarCurve> turnCurves(const FrictionSurvey& survey) {
  std::vector<PolarCurve> curves;
  for (const Way way : {Way::ccw, Way::cw}) {
    for (size_t turn = 0; turn < survey.turns; ++turn) {
      PolarCurve curve{translated("%1, turn %2").arg(wayName(way)).arg(turn + 1), colourOf(way), turn > 0, false, {}};
      for (const BreakawayEvent& event : survey.events) {
        if (event.way == way && event.turn == turn)
          curve.points.push_back({event.angle_rad, 1e3 * event.torque_Nm, 0.0, event.outlier});
      }
      if (curve.points.empty()) continue;
      std::sort(curve.points.begin(), curve.points.end(),
                [](const PolarPoint& a, const PolarPoint& b) { return a.angle_rad < b.angle_rad; });
      curve.closed = curve.points.size() >= survey.bins;
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

std::vector<PolarCurve> wayCurves(const FrictionMap& map, double scale,
                                  const std::function<Estimate(const WayBin&)>& read) {
  std::vector<PolarCurve> curves;
  for (const Way way : {Way::ccw, Way::cw}) {
    PolarCurve curve{wayName(way), colourOf(way), false, true, {}};
    for (const MapBin& bin : map.bins) {
      const WayBin& one = bin.way[static_cast<size_t>(way)];
      const Estimate estimate = read(one);
      curve.points.push_back({bin.angle_rad, scale * estimate.value, scale * estimate.standardError, one.outlier});
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

PolarCurve positionCurve(const FrictionMap& map) {
  PolarCurve curve{translated("position torque"), 3, false, true, {}};
  for (const MapBin& bin : map.bins) curve.points.push_back({bin.angle_rad, 1e3 * bin.positionTorque_Nm(), 0.0, false});
  return curve;
}

}  // namespace

QString nameOf(PolarView view) {
  switch (view) {
    case PolarView::turns:
      return translated("Breakaway, turn by turn");
    case PolarView::staticMean:
      return translated("Static friction, mean");
    case PolarView::coulomb:
      return translated("Coulomb friction");
    case PolarView::viscous:
      return translated("Viscous coefficient");
    case PolarView::total:
      return translated("Total at the map's speed");
    case PolarView::positionTorque:
      return translated("Position torque");
  }
  return {};
}

QString obstacleTo(PolarView view, const FrictionSurvey& survey) {
  if (view == PolarView::turns) return survey.events.empty() ? translated("Run the breakaway sweep first") : QString();
  if (!survey.map) return translated("Run the breakaway sweep to its end first");
  const bool moving = view == PolarView::coulomb || view == PolarView::viscous || view == PolarView::total;
  return moving && !survey.moving ? translated("Run the velocity sweep first") : QString();
}

PolarPicture pictureOf(PolarView view, const FrictionSurvey& survey) {
  const QString torque = translated("mNm");
  const auto titled = [](const char* quantity, const QString& unit) { return translated(quantity).arg(unit); };
  if (view == PolarView::turns) return {turnCurves(survey), titled("breakaway torque (%1)", torque), torque};
  if (!survey.map) return {{}, titled("breakaway torque (%1)", torque), torque};
  const FrictionMap& map = *survey.map;
  switch (view) {
    case PolarView::staticMean:
      return {wayCurves(map, 1e3, [](const WayBin& bin) { return bin.static_Nm; }),
              titled("static friction (%1)", torque), torque};
    case PolarView::coulomb:
      return {wayCurves(map, 1e3, [](const WayBin& bin) { return bin.coulomb_Nm; }),
              titled("Coulomb friction (%1)", torque), torque};
    case PolarView::viscous: {
      const QString unit = translated("µNm s/rad");
      return {wayCurves(map, 1e6, [](const WayBin& bin) { return bin.viscous_Nm_s_per_rad; }),
              titled("viscous coefficient (%1)", unit), unit};
    }
    case PolarView::total:
      return {wayCurves(map, 1e3,
                        [](const WayBin& bin) {
                          return Estimate{bin.total_Nm, 0.0};
                        }),
              translated("total at %1 rad/s (%2)").arg(map.totalVelocity_rad_per_s, 0, 'f', 2).arg(torque), torque};
    case PolarView::positionTorque:
      return {{positionCurve(map)}, titled("position torque (%1)", torque), torque};
    case PolarView::turns:
      break;
  }
  return {};
}

}  // namespace breakaway
