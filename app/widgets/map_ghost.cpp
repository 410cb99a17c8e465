#include "widgets/map_ghost.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "report/run_comparison.h"
#include "widgets/axis_units.h"

namespace breakaway {

namespace {

constexpr double outside = 1.08;  // times the highest value, what the ring keeps away from the centre

QString ghostWords(const char* text) {
  return QCoreApplication::translate("MapGhost", text);
}

struct Quantity {
  Estimate WayBin::*of = nullptr;
  double scale = 0.0;
};

Quantity quantityOf(MapView view, const AxisUnits& units) {
  switch (view) {
    case MapView::turns:
    case MapView::staticMean:
      return {&WayBin::static_Nm, units.torqueScale};
    case MapView::coulomb:
      return {&WayBin::coulomb_Nm, units.torqueScale};
    case MapView::viscous:
      return {&WayBin::viscous_Nm_s_per_rad, units.viscousScale};
    case MapView::total:
    case MapView::positionTorque:
      break;
  }
  return {};
}

double highestOf(const MapPicture& picture) {
  double most = 0.0;
  for (const MapCurve& curve : picture.curves)
    for (const MapPoint& point : curve.points) most = std::max(most, std::abs(point.value));
  return most;
}

void addRing(const FrictionMap& earlier, const FrictionMap& now, const Quantity& quantity, MapPicture& picture) {
  const std::vector<Estimate> differences = meanDifference(earlier, now, quantity.of);
  double most = 0.0;
  for (const Estimate& one : differences)
    if (std::isfinite(one.value)) most = std::max(most, std::abs(quantity.scale * one.value));
  const double zero = outside * highestOf(picture) + most;  // no difference reaches down to what differs
  MapCurve none{ghostWords(QT_TRANSLATE_NOOP("MapGhost", "no difference")), 2, true, true, {}};
  MapCurve ring{ghostWords(QT_TRANSLATE_NOOP("MapGhost", "now − earlier")), 2, false, true, {}};
  none.part = MapPart::noDifference;
  ring.part = MapPart::difference;
  none.lifted = ring.lifted = zero;
  for (const Estimate& one : differences) {
    const double at = now.bins[ring.points.size()].angle_rad;
    ring.points.push_back({at, zero + quantity.scale * one.value, quantity.scale * one.standardError, false});
    none.points.push_back({at, zero, 0.0, false});
  }
  picture.curves.push_back(std::move(none));
  picture.curves.push_back(std::move(ring));
}

}  // namespace

void layBeneath(const FrictionMap& earlier, const FrictionMap* now, MapView view, MapPicture& picture) {
  if (now != nullptr && now->axis != earlier.axis) return;
  MapPicture ghost = pictureOf(view, earlier);
  for (MapCurve& curve : ghost.curves) {
    curve.name = ghostWords(QT_TRANSLATE_NOOP("MapGhost", "%1, earlier")).arg(curve.name);
    curve.part = MapPart::earlier;
  }
  if (picture.curves.empty()) {
    picture = std::move(ghost);
    return;
  }
  picture.curves.insert(picture.curves.begin(), ghost.curves.begin(), ghost.curves.end());
  const Quantity quantity = quantityOf(view, unitsOf(earlier.axis));
  if (now != nullptr && quantity.of != nullptr) addRing(earlier, *now, quantity, picture);
}

}  // namespace breakaway
