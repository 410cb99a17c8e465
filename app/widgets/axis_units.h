// Units and words in which people read an axis' quantities: a rotor's or a linear one's.
#pragma once

#include <QString>

#include "base/axis.h"
#include "friction/friction_map.h"

namespace breakaway {

struct AxisUnits {
  QString torque;
  double torqueScale;  ///< shown = scale · SI
  QString viscous;
  double viscousScale;
  QString constant, inertia;
  double inertiaScale;
  QString speed, backEmf;
  QString gain, integral, derivative;  ///< of the velocity controller
};

AxisUnits unitsOf(Axis axis);

/// "clockwise", "backwards" …, and short for tables: "cw", "back" …
QString wayName(Way way, Axis axis);
QString shortWayName(Way way, Axis axis);

}  // namespace breakaway
