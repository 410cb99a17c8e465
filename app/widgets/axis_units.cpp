#include "widgets/axis_units.h"

#include <QCoreApplication>

namespace breakaway {

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("AxisUnits", text);
}

}  // namespace

AxisUnits unitsOf(Axis axis) {
  if (axis == Axis::linear) {
    return {translated(QT_TRANSLATE_NOOP("AxisUnits", "N")),
            1.0,
            translated(QT_TRANSLATE_NOOP("AxisUnits", "N s/m")),
            1.0,
            translated(QT_TRANSLATE_NOOP("AxisUnits", "N/A")),
            translated(QT_TRANSLATE_NOOP("AxisUnits", "kg")),
            1.0,
            translated(QT_TRANSLATE_NOOP("AxisUnits", "m/s")),
            translated(QT_TRANSLATE_NOOP("AxisUnits", "V s/m")),
            translated(QT_TRANSLATE_NOOP("AxisUnits", "A s/m")),
            translated(QT_TRANSLATE_NOOP("AxisUnits", "A/m")),
            translated(QT_TRANSLATE_NOOP("AxisUnits", "A s²/m"))};
  }
  return {translated(QT_TRANSLATE_NOOP("AxisUnits", "mNm")),
          1e3,
          translated(QT_TRANSLATE_NOOP("AxisUnits", "µNm s/rad")),
          1e6,
          translated(QT_TRANSLATE_NOOP("AxisUnits", "Nm/A")),
          translated(QT_TRANSLATE_NOOP("AxisUnits", "g cm²")),
          1e7,
          translated(QT_TRANSLATE_NOOP("AxisUnits", "rad/s")),
          translated(QT_TRANSLATE_NOOP("AxisUnits", "V s/rad")),
          translated(QT_TRANSLATE_NOOP("AxisUnits", "A s/rad")),
          translated(QT_TRANSLATE_NOOP("AxisUnits", "A/rad")),
          translated(QT_TRANSLATE_NOOP("AxisUnits", "A s²/rad"))};
}

QString wayName(Way way, Axis axis) {
  if (axis == Axis::linear)
    return way == Way::cw ? translated(QT_TRANSLATE_NOOP("AxisUnits", "backwards"))
                          : translated(QT_TRANSLATE_NOOP("AxisUnits", "forwards"));
  return way == Way::cw ? translated(QT_TRANSLATE_NOOP("AxisUnits", "clockwise"))
                        : translated(QT_TRANSLATE_NOOP("AxisUnits", "counter-clockwise"));
}

QString shortWayName(Way way, Axis axis) {
  if (axis == Axis::linear)
    return way == Way::cw ? translated(QT_TRANSLATE_NOOP("AxisUnits", "back"))
                          : translated(QT_TRANSLATE_NOOP("AxisUnits", "fwd"));
  return way == Way::cw ? translated(QT_TRANSLATE_NOOP("AxisUnits", "cw"))
                        : translated(QT_TRANSLATE_NOOP("AxisUnits", "ccw"));
}

}  // namespace breakaway
