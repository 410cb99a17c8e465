#include "widgets/axis_units.h"

#include <QCoreApplication>

namespace breakaway {

namespace {

QString unitName(const char* text) {
  return QCoreApplication::translate("AxisUnits", text);
}

}  // namespace

AxisUnits unitsOf(Axis axis) {
  if (axis == Axis::linear) {
    return {unitName(QT_TRANSLATE_NOOP("AxisUnits", "N")),
            1.0,
            unitName(QT_TRANSLATE_NOOP("AxisUnits", "N s/m")),
            1.0,
            unitName(QT_TRANSLATE_NOOP("AxisUnits", "N/A")),
            unitName(QT_TRANSLATE_NOOP("AxisUnits", "kg")),
            1.0,
            unitName(QT_TRANSLATE_NOOP("AxisUnits", "m/s")),
            unitName(QT_TRANSLATE_NOOP("AxisUnits", "V s/m")),
            unitName(QT_TRANSLATE_NOOP("AxisUnits", "A s/m")),
            unitName(QT_TRANSLATE_NOOP("AxisUnits", "A/m")),
            unitName(QT_TRANSLATE_NOOP("AxisUnits", "A s²/m"))};
  }
  return {unitName(QT_TRANSLATE_NOOP("AxisUnits", "mNm")),
          1e3,
          unitName(QT_TRANSLATE_NOOP("AxisUnits", "µNm s/rad")),
          1e6,
          unitName(QT_TRANSLATE_NOOP("AxisUnits", "Nm/A")),
          unitName(QT_TRANSLATE_NOOP("AxisUnits", "g cm²")),
          1e7,
          unitName(QT_TRANSLATE_NOOP("AxisUnits", "rad/s")),
          unitName(QT_TRANSLATE_NOOP("AxisUnits", "V s/rad")),
          unitName(QT_TRANSLATE_NOOP("AxisUnits", "A s/rad")),
          unitName(QT_TRANSLATE_NOOP("AxisUnits", "A/rad")),
          unitName(QT_TRANSLATE_NOOP("AxisUnits", "A s²/rad"))};
}

QString wayName(Way way, Axis axis) {
  if (axis == Axis::linear)
    return way == Way::cw ? unitName(QT_TRANSLATE_NOOP("AxisUnits", "backwards"))
                          : unitName(QT_TRANSLATE_NOOP("AxisUnits", "forwards"));
  return way == Way::cw ? unitName(QT_TRANSLATE_NOOP("AxisUnits", "clockwise"))
                        : unitName(QT_TRANSLATE_NOOP("AxisUnits", "counter-clockwise"));
}

QString shortWayName(Way way, Axis axis) {
  if (axis == Axis::linear)
    return way == Way::cw ? unitName(QT_TRANSLATE_NOOP("AxisUnits", "back"))
                          : unitName(QT_TRANSLATE_NOOP("AxisUnits", "fwd"));
  return way == Way::cw ? unitName(QT_TRANSLATE_NOOP("AxisUnits", "cw"))
                        : unitName(QT_TRANSLATE_NOOP("AxisUnits", "ccw"));
}

}  // namespace breakaway
