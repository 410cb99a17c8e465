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
    return {translated("N"),
            1.0,
            translated("N s/m"),
            1.0,
            translated("N/A"),
            translated("kg"),
            1.0,
            translated("m/s"),
            translated("V s/m"),
            translated("A s/m"),
            translated("A/m"),
            translated("A s²/m")};
  }
  return {translated("mNm"),
          1e3,
          translated("µNm s/rad"),
          1e6,
          translated("Nm/A"),
          translated("g cm²"),
          1e7,
          translated("rad/s"),
          translated("V s/rad"),
          translated("A s/rad"),
          translated("A/rad"),
          translated("A s²/rad")};
}

QString wayName(Way way, Axis axis) {
  if (axis == Axis::linear) return way == Way::cw ? translated("backwards") : translated("forwards");
  return way == Way::cw ? translated("clockwise") : translated("counter-clockwise");
}

QString shortWayName(Way way, Axis axis) {
  if (axis == Axis::linear) return way == Way::cw ? translated("back") : translated("fwd");
  return way == Way::cw ? translated("cw") : translated("ccw");
}

}  // namespace breakaway
